// A magnifying glass over the handles at the wall, as millimetres decide what a hand feels.

import {circle_path, line_path} from './pen.js';
import {draw_walls} from './walls.js';

// A magnifying glass over the handles at the wall.
export function draw_lens(pen, picture, theme) {
  const {lens} = picture,
    r = lens.radius,
    on_stage = picture.camera.point(lens.centre),
    small_r = r / lens.times;
  const d = [lens.at[0] - on_stage[0], lens.at[1] - on_stage[1]],
    length = Math.hypot(...d) || 1;
  pen.path(circle_path(on_stage, Math.max(small_r, 9)), {stroke: theme.muted, width: 1.2});
  pen.path(
    line_path(
      [on_stage[0] + (Math.max(small_r, 9) * d[0]) / length, on_stage[1] + (Math.max(small_r, 9) * d[1]) / length],
      [lens.at[0] - (r * d[0]) / length, lens.at[1] - (r * d[1]) / length],
    ),
    {stroke: theme.muted, width: 1.2, dash: [3, 4]},
  );
  pen.path(circle_path(lens.at, r), {fill: theme.paper});
  pen.clip(circle_path(lens.at, r), () => {
    draw_walls(pen, lens.camera, lens.walls, theme, picture.is_hollow, 3 * r);
    if (picture.locus)
      pen.curve([picture.locus.points.flatMap(lens.camera.point)], {
        stroke: theme.holds,
        width: 3.4,
        alpha: picture.locus.is_held ? 1 : 0.3,
      });
    for (const path of picture.paths)
      pen.curve([path.points.flatMap(lens.camera.point)], {stroke: path.color, width: 2.4});
    for (const other of [...picture.others, ...(picture.focus ? [picture.focus] : [])])
      pen.path(circle_path(lens.camera.point(other.point), 8), {fill: other.color, stroke: theme.paper, width: 2});
  });
  pen.path(circle_path(lens.at, r), {stroke: theme.ink, width: 2});
  pen.label(lens.times + ' × larger', lens.at[0], lens.at[1] + r + 17, {
    size: 12,
    align: 'middle',
    color: theme.muted,
    halo: theme.paper,
  });
}
