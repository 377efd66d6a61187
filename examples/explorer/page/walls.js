// The virtual walls: their surface as a line, and what lies behind it in a tint with slanting strokes.

import { line_path, points_path } from './pen.js';

// points: every 2 a segment of the plane, every 3 a triangle in space [m]. is_inside(pixel) says whether a pixel lies in a wall.
export function draw_walls(pen, camera, points, theme) {
  if (camera.is_space) {
    for (let k = 0; k + 2 < points.length; k += 3)
      pen.path(points_path(points.slice(k, k + 3).map(camera.point), true), {fill: theme.wall, stroke: theme.wall_line, width: 0.5, alpha: 0.35});
    return;
  }
  let surface = "", strokes = "";
  for (let k = 0; k + 1 < points.length; k += 2) {
    const a = camera.point(points[k]), b = camera.point(points[k + 1]), length = Math.hypot(b[0] - a[0], b[1] - a[1]);
    surface += line_path(a, b);
    // The free side lies to the left of a segment; the strokes go to the right.
    const t = [(b[0] - a[0]) / (length || 1), (b[1] - a[1]) / (length || 1)], n = [-t[1], t[0]];
    for (let s = 5 - (k % 2); s < length; s += 11) {
      const from = [a[0] + s * t[0], a[1] + s * t[1]];
      strokes += line_path(from, [from[0] + 10 * n[0] - 6 * t[0], from[1] + 10 * n[1] - 6 * t[1]]);
    }
  }
  pen.path(strokes, {stroke: theme.wall_line, width: 1, alpha: 0.55});
  pen.path(surface, {stroke: theme.wall_line, width: 2.4});
}
