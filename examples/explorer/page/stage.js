// The picture: walls, device, forces, hand and paths, in the order in which they lie over each other.

import {draw_spring} from './arrows.js';
import {draw_forces, fill_cone, outline_cone} from './forces.js';
import {draw_lens} from './lens.js';
import {circle_path} from './pen.js';
import {draw_device} from './sketch.js';
import {draw_floor, draw_map, draw_scale} from './surroundings.js';
import {draw_walls} from './walls.js';

// picture: {camera, walls, rows, brakes, handle, cones: [{points, is_present, name}], arrows: [{id, vector,
// label, is_force}], references: [{vector, label}], force_scale, motion_scale [pixels per N, per m/s],
// paths: [{points, color}], others: [{point, color}], pointer, map, lens, shown: Set of layers, gamma:
// {from, to, text}}.
export function draw_stage(pen, picture, theme) {
  const {camera, handle, shown} = picture,
    small = pen.width < 520;
  const at = handle && camera.point(handle),
    link_width = small ? 11 : 15;
  if (picture.map && !camera.is_space) draw_map(pen, picture, theme);
  draw_walls(pen, camera, picture.walls, theme, picture.is_hollow, 18);
  if (picture.map && camera.is_space) draw_map(pen, picture, theme);
  if (camera.is_space) draw_floor(pen, picture, theme);
  draw_scale(pen, camera, theme);
  if (at && shown.has('others'))
    for (const cone of picture.cones) if (!cone.is_present) outline_cone(pen, picture, at, cone, theme);
  if (at && shown.has('cone') && !camera.is_space)
    for (const cone of picture.cones) if (cone.is_present) fill_cone(pen, picture, at, cone, theme);
  draw_device(pen, camera, picture.rows, picture.brakes, theme, {
    width: link_width,
    labels: shown.has('brakes'),
  });
  if (at && shown.has('cone') && camera.is_space)
    for (const cone of picture.cones) if (cone.is_present) fill_cone(pen, picture, at, cone, theme);
  for (const path of picture.paths)
    pen.curve([path.points.flatMap(camera.point)], {stroke: path.color, width: 2, alpha: 0.8});
  for (const other of picture.others)
    pen.path(circle_path(camera.point(other.point), small ? 4.5 : 6), {
      fill: other.color,
      stroke: theme.paper,
      width: 1.5,
    });
  if (at) {
    if (picture.pointer) {
      const to = camera.point(picture.pointer);
      draw_spring(pen, at, to, {stroke: theme.hand, width: 2});
      pen.path(circle_path(to, 7), {fill: theme.hand, stroke: theme.paper, width: 2});
    }
    draw_forces(pen, picture, at, theme);
    if (picture.shows_hand) draw_hand(pen, at, theme, small ? 0.8 : 1);
  }
  if (picture.lens) draw_lens(pen, picture, theme);
}

// A hand that holds the handle: the thumb and a finger, seen from above.
function draw_hand(pen, at, theme, size) {
  const c = Math.cos(-0.62),
    s = Math.sin(-0.62); // the arm comes from the lower right
  const p = (x, y) =>
    (at[0] + size * (c * x - s * y)).toFixed(1) + ' ' + (at[1] + size * (s * x + c * y)).toFixed(1);
  const fingers = [
    [
      [-9, -3],
      [-17, 20],
    ],
    [
      [-2, -10],
      [-6, 20],
    ],
    [
      [7, -8],
      [6, 22],
    ],
    [
      [13, 1],
      [14, 28],
    ],
  ];
  pen.path(
    `M${p(-21, 20)}C${p(-24, 40)} ${p(-14, 56)} ${p(-13, 92)}L${p(17, 92)}C${p(17, 62)} ${p(25, 44)} ${p(19, 24)}C${p(8, 12)} ${p(-12, 10)} ${p(-21, 20)}Z`,
    {fill: theme.hand, alpha: 0.24},
  );
  pen.path(fingers.map(([tip, root]) => `M${p(...tip)}L${p(...root)}`).join(''), {
    stroke: theme.hand,
    width: 9 * size,
    alpha: 0.3,
  });
}
