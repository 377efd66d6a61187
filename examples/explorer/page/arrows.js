// Arrows of forces and velocities, and the cones of forces that brakes can make.

import {line_path, points_path} from './pen.js';

// An arrow from a pixel along a vector of pixels. Where the vector is longer than most, the shaft is broken
// by a zigzag, and the head stands at most. Returns the head.
export function draw_arrow(pen, from, vector, style, most = Infinity) {
  const full = Math.hypot(...vector);
  if (!(full > 0.5)) return from;
  const is_cut = full > most,
    length = is_cut ? most : full,
    a = vector.map(c => c / full),
    b = [-a[1], a[0]];
  const width = style.width,
    head = Math.min(length, 3.2 * width + 5),
    half = 0.42 * head;
  const at = (s, t) => [from[0] + s * a[0] + t * b[0], from[1] + s * a[1] + t * b[1]],
    neck = length - 0.82 * head;
  const shaft = is_cut
    ? points_path([at(0, 0), at(neck - 22, 0), at(neck - 18, 5), at(neck - 12, -5), at(neck - 8, 0), at(neck, 0)])
    : line_path(from, at(Math.max(0, neck), 0));
  const outline = points_path(
    [at(length, 0), at(length - head, half), at(length - 0.82 * head, 0), at(length - head, -half)],
    true,
  );
  pen.path(shaft, {stroke: style.color, width, dash: style.dash, cap: 'butt', alpha: style.alpha});
  pen.path(
    outline,
    style.is_open
      ? {fill: style.paper, stroke: style.color, width: 1.5, alpha: style.alpha}
      : {fill: style.color, alpha: style.alpha},
  );
  return at(length, 0);
}

// A polygon of forces in the plane [N] about a point on the screen.
export function draw_cone(pen, camera, at, points, scale, style) {
  pen.path(
    points_path(
      points.map(f => {
        const d = camera.vector(f);
        return [at[0] + scale * d[0], at[1] + scale * d[1]];
      }),
      true,
    ),
    style,
  );
}

// Triangles of forces in space, far ones first, each as bright as it faces the light.
export function draw_solid_cone(pen, camera, at, points, scale, style) {
  const faces = new Map(),
    largest = Math.max(...points.map(f => Math.hypot(...f))) ** 2;
  for (let k = 0; k + 2 < points.length; k += 3) {
    const corners = points.slice(k, k + 3),
      edges = [0, 1].map(j => [0, 1, 2].map(i => corners[j + 1][i] - corners[0][i]));
    const normal = [0, 1, 2].map(
        i => edges[0][(i + 1) % 3] * edges[1][(i + 2) % 3] - edges[0][(i + 2) % 3] * edges[1][(i + 1) % 3],
      ),
      size = Math.hypot(...normal);
    if (!(size > 1e-9 * largest)) continue;
    // Triangles of one flat face are painted as one, so that no seam shows.
    const unit = normal.map(c => c / size),
      sign = Math.sign(unit.find(c => Math.abs(c) > 1e-3)),
      side = unit.reduce((sum, c, i) => sum + sign * c * corners[0][i], 0) / Math.sqrt(largest);
    const key = [...unit.map(c => sign * c), side].map(c => Math.round(50 * c) + 0).join();
    if (!faces.has(key)) faces.set(key, {path: '', depth: 0, count: 0, light: Math.abs(unit[2])});
    const face = faces.get(key),
      turn = turned(corners.map(f => camera.vector(f)));
    face.path += points_path(
      (turn < 0 ? [...corners].reverse() : corners).map(f => {
        const d = camera.vector(f);
        return [at[0] + scale * d[0], at[1] + scale * d[1]];
      }),
      true,
    );
    face.depth += camera.depth(corners[0]) + camera.depth(corners[1]) + camera.depth(corners[2]);
    ++face.count;
  }
  const order = [...faces.values()].sort((a, b) => a.depth / a.count - b.depth / b.count);
  for (const face of order) pen.path(face.path, {fill: style.fill, alpha: style.alpha * (0.5 + 0.5 * face.light)});
}

const turned = ([a, b, c]) => (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);

// A spring between two pixels, with which the hand pulls.
export function draw_spring(pen, from, to, style) {
  const d = [to[0] - from[0], to[1] - from[1]],
    length = Math.hypot(...d);
  if (length < 6) return;
  const a = d.map(c => c / length),
    b = [-a[1], a[0]],
    points = [from],
    turns = 9,
    ends = Math.min(10, 0.15 * length);
  for (let k = 0; k <= 2 * turns; ++k) {
    const s = ends + ((length - 2 * ends) * k) / (2 * turns),
      t = k === 0 || k === 2 * turns ? 0 : k % 2 ? 4.5 : -4.5;
    points.push([from[0] + s * a[0] + t * b[0], from[1] + s * a[1] + t * b[1]]);
  }
  points.push(to);
  pen.path(points_path(points), style);
}
