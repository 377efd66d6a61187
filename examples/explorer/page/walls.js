// The virtual walls: their surface as a line, and what lies behind it in a tint with slanting strokes.

import {line_path, points_path} from './pen.js';

// points: every 2 a segment of the plane with the wall to its left, every 3 a triangle in space [m].
// is_hollow: the wall lies to the right. depth: of the tint behind the surface [pixels].
export function draw_walls(pen, camera, points, theme, is_hollow, depth) {
  if (camera.is_space) {
    const triangles = [];
    for (let k = 0; k + 2 < points.length; k += 3)
      triangles.push(points_path(points.slice(k, k + 3).map(camera.point), true));
    pen.path(triangles.join(''), {
      fill: theme.wall,
      stroke: triangles.length > 20 ? theme.wall_line : '',
      width: 0.3,
      alpha: 0.45,
    });
    return;
  }
  let surface = '',
    strokes = '',
    tint = '';
  for (let k = 0; k + 1 < points.length; k += 2) {
    const a = camera.point(points[k]),
      b = camera.point(points[k + 1]),
      length = Math.hypot(b[0] - a[0], b[1] - a[1]);
    if (!(length > 0)) continue;
    const t = [(b[0] - a[0]) / length, (b[1] - a[1]) / length],
      side = is_hollow ? -1 : 1,
      n = [side * t[1], -side * t[0]];
    const behind = (p, s) => [p[0] + s * n[0], p[1] + s * n[1]];
    surface += line_path(a, b);
    tint += points_path([a, b, behind(b, depth), behind(a, depth)], true);
    const pitch = 12,
      count = Math.max(1, Math.round(length / pitch));
    for (let s = 0; s < count; ++s) {
      const from = [a[0] + (((s + 0.5) * length) / count) * t[0], a[1] + (((s + 0.5) * length) / count) * t[1]];
      if (from[0] < -20 || from[0] > pen.width + 20 || from[1] < -20 || from[1] > pen.height + 20) continue;
      strokes += line_path(from, [from[0] + 10 * n[0] + 6 * t[0], from[1] + 10 * n[1] + 6 * t[1]]);
    }
  }
  const is_closed = points.length > 4 && Math.hypot(...points[0].map((c, i) => c - points.at(-1)[i])) < 1e-9;
  if (is_closed && !is_hollow) tint = points_path(points.map(camera.point), true);
  pen.path(tint, {fill: theme.wall, stroke: theme.wall, width: 1});
  pen.path(strokes, {stroke: theme.wall_line, width: 1, alpha: 0.5});
  pen.path(surface, {stroke: theme.wall_line, width: 2.4});
}
