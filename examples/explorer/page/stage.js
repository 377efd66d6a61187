// The picture: walls, device, forces, hand and paths, in the order in which they lie over each other.

import {draw_spring} from './arrows.js';
import {draw_area, draw_forces, name_cone} from './forces.js';
import {draw_lens, draw_motion} from './lens.js';
import {circle_path, make_labels} from './pen.js';
import {draw_device, label_brakes} from './sketch.js';
import {draw_floor, draw_map, draw_scale} from './surroundings.js';
import {draw_walls} from './walls.js';

// picture: of make_picture().
export function draw_stage(pen, picture, theme) {
  const {camera, handle, shown} = picture,
    small = pen.width < 520,
    labels = make_labels(pen);
  const at = handle && camera.point(handle);
  const draw_areas = is_present => {
    for (const cone of picture.cones)
      if (at && !!cone.is_present === is_present) draw_area(pen, picture, at, cone, theme);
  };
  if (picture.map && !camera.is_space) draw_map(pen, picture, theme);
  draw_walls(pen, camera, picture.walls, theme, picture.is_hollow, 18);
  if (picture.map && camera.is_space) draw_map(pen, picture, theme);
  if (picture.map) labels.take(pen.width - 110, pen.height - 30, 110, 28);
  if (camera.is_space) draw_floor(pen, picture, theme);
  labels.take(0.13 * pen.width, pen.height - 16, 0.13 * pen.width, 16);
  draw_areas(false);
  if (!camera.is_space) draw_areas(true);
  draw_device(pen, camera, picture.rows, picture.brakes, theme, {width: small ? 11 : 15});
  if (camera.is_space) draw_areas(true);
  draw_motion(pen, camera, picture, theme, picture.others, small ? 4.5 : 6);
  if (picture.lens) labels.take(...picture.lens.at, picture.lens.radius, picture.lens.radius + 20);
  if (at) {
    labels.take(...at, 9, 9);
    if (picture.pointer) {
      const to = camera.point(picture.pointer);
      draw_spring(pen, at, to, {stroke: theme.hand, width: 2});
      pen.path(circle_path(to, 7), {fill: theme.hand, stroke: theme.paper, width: 2});
    }
    draw_forces(pen, picture, labels, at, theme);
    if (shown.has('references') && !camera.is_space)
      for (const cone of [...picture.cones].reverse()) name_cone(labels, picture, at, cone, theme);
    if (picture.shows_hand) draw_hand(pen, at, theme, small ? 0.8 : 1);
  }
  if (shown.has('brakes')) label_brakes(pen, labels, camera, picture.rows, picture.brakes, theme);
  if (picture.lens) draw_lens(pen, picture, theme);
  draw_scale(pen, camera, theme);
}

// A hand that holds the handle: the thumb and a finger, seen from above.
function draw_hand(pen, at, theme, size) {
  const c = Math.cos(-0.62),
    s = Math.sin(-0.62); // the arm comes from the lower right
  const p = (x, y) => (at[0] + size * (c * x - s * y)).toFixed(1) + ' ' + (at[1] + size * (s * x + c * y)).toFixed(1);
  const fingers = [
    ...[[-9, -3, -17, 20], [-2, -10, -6, 20]], // tip and root
    ...[[7, -8, 6, 22], [13, 1, 14, 28]],
  ];
  pen.path(
    `M${p(-21, 20)}C${p(-24, 40)} ${p(-14, 56)} ${p(-13, 92)}L${p(17, 92)}C${p(17, 62)} ${p(25, 44)} ${p(19, 24)}C${p(8, 12)} ${p(-12, 10)} ${p(-21, 20)}Z`,
    {fill: theme.hand, alpha: 0.24},
  );
  pen.path(fingers.map(([x, y, u, v]) => `M${p(x, y)}L${p(u, v)}`).join(''), {
    stroke: theme.hand,
    width: 9 * size,
    alpha: 0.3,
  });
}
