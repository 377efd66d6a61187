// Motion at the wall, in the picture and under a magnifying glass, as millimetres decide what a hand feels.

import {circle_path, line_path, points_path} from './pen.js';
import {frame_at, length_of, minus} from './vectors.js';
import {draw_walls} from './walls.js';

// The curve of a brake that holds, the paths of the hands, and a dot for each of these hands.
export function draw_motion(pen, camera, picture, theme, hands, radius) {
  const {locus, paths} = picture,
    draw = (points, style) => pen.path(points_path(points.map(camera.point)), style);
  if (locus) draw(locus.points, {stroke: theme.holds, width: 3.4, alpha: locus.is_held ? 1 : 0.3});
  for (const {points, color} of paths) draw(points, {stroke: color, width: 2.2, alpha: 0.9});
  for (const {point, color} of hands)
    pen.path(circle_path(camera.point(point), radius), {fill: color, stroke: theme.paper, width: 1.5});
}

export function draw_lens(pen, picture, theme) {
  const {camera, centre, at, radius, times, walls} = picture.lens,
    on_stage = picture.camera.point(centre),
    small_radius = Math.max(radius / times, 9),
    away = minus(at, on_stage),
    from = frame_at(on_stage, away);
  pen.path(circle_path(on_stage, small_radius), {stroke: theme.muted, width: 1.2});
  pen.path(line_path(from(small_radius), from(length_of(away) - radius)), {
    stroke: theme.muted,
    width: 1.2,
    dash: [3, 4],
  });
  pen.path(circle_path(at, radius), {fill: theme.paper});
  pen.clip(circle_path(at, radius), () => {
    draw_walls(pen, camera, walls, theme, picture.is_hollow, 3 * radius);
    draw_motion(pen, camera, picture, theme, [...picture.others, picture.focus].filter(Boolean), 8);
  });
  pen.path(circle_path(at, radius), {stroke: theme.ink, width: 2});
  const style = {size: 12, align: 'middle', color: theme.muted, halo: theme.paper};
  pen.label(times + ' × larger', at[0], at[1] + radius + 17, style);
}
