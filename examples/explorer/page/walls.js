// The virtual walls: their surface as a line, and what lies behind it in a tint with slanting strokes.

import {line_path, points_path} from './pen.js';
import {frame_at, length_of, minus} from './vectors.js';

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
      length = length_of(minus(b, a)),
      at = frame_at(a, minus(b, a)),
      side = is_hollow ? 1 : -1; // behind the surface
    if (!(length > 0)) continue;
    surface += line_path(a, b);
    tint += points_path([a, b, at(length, side * depth), at(0, side * depth)], true);
    const pitch = 12,
      count = Math.max(1, Math.round(length / pitch));
    for (let stroke = 0; stroke < count; ++stroke) {
      const s = ((stroke + 0.5) * length) / count,
        [x, y] = at(s);
      if (x > -20 && x < pen.width + 20 && y > -20 && y < pen.height + 20)
        strokes += line_path([x, y], at(s + 6, side * 10));
    }
  }
  const is_closed = points.length > 4 && length_of(minus(points[0], points.at(-1))) < 1e-9;
  if (is_closed && !is_hollow) tint = points_path(points.map(camera.point), true);
  pen.path(tint, {fill: theme.wall, stroke: theme.wall, width: 1});
  pen.path(strokes, {stroke: theme.wall_line, width: 1, alpha: 0.5});
  pen.path(surface, {stroke: theme.wall_line, width: 2.4});
}
