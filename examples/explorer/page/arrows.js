// Arrows of forces and velocities, and the cones of forces that brakes can make.

import {line_path, points_path} from './pen.js';
import {cross, dot, frame_at, length_of, minus, plus, times} from './vectors.js';

// An arrow from a pixel along a vector of pixels. Where the vector is longer than most, the shaft is broken
// by a zigzag, and the head stands at most. Returns the head.
export function draw_arrow(pen, from, vector, style, most = Infinity) {
  const full = length_of(vector);
  if (!(full > 0.5)) return from;
  const is_cut = full > most,
    length = Math.min(full, most),
    at = frame_at(from, vector),
    {width, color, alpha} = style,
    head = Math.min(length, 3.2 * width + 5),
    half = 0.42 * head,
    neck = length - 0.82 * head;
  const shaft = is_cut
    ? points_path([from, at(neck - 22), at(neck - 18, 5), at(neck - 12, -5), at(neck - 8), at(neck)])
    : line_path(from, at(Math.max(0, neck)));
  const outline = points_path([at(length), at(length - head, half), at(neck), at(length - head, -half)], true);
  pen.path(shaft, {stroke: color, width, dash: style.dash, cap: 'butt', alpha});
  pen.path(outline, style.is_open ? {fill: style.paper, stroke: color, width: 1.5, alpha} : {fill: color, alpha});
  return at(length);
}

// The pixels of forces [N] about a point on the screen.
const heads_of = (camera, at, forces, scale) => forces.map(f => plus(at, camera.vector(f), scale));

// A polygon of forces in the plane.
export function draw_cone(pen, camera, at, points, scale, style) {
  pen.path(points_path(heads_of(camera, at, points, scale), true), style);
}

// Triangles of forces in space, far ones first, each as bright as it faces the light.
export function draw_solid_cone(pen, camera, at, points, scale, style) {
  const faces = new Map(),
    largest = Math.max(...points.map(length_of)) ** 2;
  for (let k = 0; k + 2 < points.length; k += 3) {
    const corners = points.slice(k, k + 3),
      normal = cross(minus(corners[1], corners[0]), minus(corners[2], corners[1])),
      size = length_of(normal);
    if (!(size > 1e-9 * largest)) continue;
    // Triangles of one flat face are painted as one, so that no seam shows.
    const unit = times(1 / size, normal),
      sign = Math.sign(unit.find(c => Math.abs(c) > 1e-3)),
      side = (sign * dot(unit, corners[0])) / Math.sqrt(largest),
      key = [...times(sign, unit), side].map(c => Math.round(50 * c) + 0).join();
    if (!faces.has(key)) faces.set(key, {path: '', depth: 0, count: 0, light: Math.abs(unit[2])});
    const face = faces.get(key),
      pixels = heads_of(camera, at, corners, scale);
    face.path += points_path(turned(pixels) < 0 ? pixels.reverse() : pixels, true);
    face.depth += camera.depth(corners[0]) + camera.depth(corners[1]) + camera.depth(corners[2]);
    ++face.count;
  }
  const order = [...faces.values()].sort((a, b) => a.depth / a.count - b.depth / b.count);
  for (const face of order) pen.path(face.path, {fill: style.fill, alpha: style.alpha * (0.5 + 0.5 * face.light)});
}

const turned = ([a, b, c]) => (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);

// A spring between two pixels, with which the hand pulls.
export function draw_spring(pen, from, to, style) {
  const d = minus(to, from),
    length = length_of(d);
  if (length < 6) return;
  const at = frame_at(from, d),
    points = [from],
    turns = 9,
    ends = Math.min(10, 0.15 * length);
  for (let k = 0; k <= 2 * turns; ++k)
    points.push(
      at(ends + ((length - 2 * ends) * k) / (2 * turns), k === 0 || k === 2 * turns ? 0 : k % 2 ? 4.5 : -4.5),
    );
  pen.path(points_path([...points, to]), style);
}
