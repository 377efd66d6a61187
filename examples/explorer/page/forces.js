// Forces and velocities at the handle: cones, reference forces, arrows, and the angle gamma.

import {draw_arrow, draw_cone, draw_solid_cone} from './arrows.js';
import {points_path} from './pen.js';
import {length_of, minus, plus, times, unit} from './vectors.js';

export const min_length = 24; // of an arrow that is taken by its head; shorter ones wait aside [pixels]
export const max_arrow = 0.36; // of the smaller side of the picture; longer ones are cut [1]

// Heads are labelled after all arrows are drawn. Sets the head of each arrow, for its grip.
export function draw_forces(pen, picture, labels, at, theme) {
  const {camera, shown} = picture,
    most = max_arrow * Math.min(pen.width, pen.height),
    names = [];
  const draw = (vector, scale, style) => {
    const d = times(scale, camera.vector(vector)),
      head = draw_arrow(pen, at, d, style, most);
    return length_of(d) > 1 ? head : null;
  };
  if (shown.has('references'))
    for (const {vector, label} of picture.references) {
      const head = draw(vector, picture.force_scale, {color: theme.muted, width: 1.3, dash: [5, 4]});
      if (head) names.push([head, label, {color: theme.muted, size: 13.5}]);
    }
  for (const arrow of picture.arrows) {
    if (!shown.has(arrow.layer)) continue;
    const style = arrow_style(arrow.id, theme);
    arrow.head = draw(arrow.vector, picture[arrow.scale || 'force_scale'], style);
    if (arrow.head)
      names.unshift([
        arrow.head,
        arrow.label,
        {color: style.color, weight: 600, size: 16.5},
        arrow.id === picture.marked ? 19 : 5,
      ]);
  }
  if (picture.gamma && shown.has('made') && shown.has('Fd')) draw_angle(pen, picture, labels, at, theme);
  for (const [head, text, style, distance = 5] of names) {
    const d = minus(head, at);
    if (text && length_of(d) > (/^(v|F_\{[dh]\})$/.test(text) ? min_length : 12))
      labels.put(text, head, unit(d), distance, {math: true, halo: theme.paper, ...style});
  }
}

export const arrow_style = (id, theme) =>
  ({
    Fd: {color: theme.wanted, width: 2.2},
    Fc: {color: theme.made, width: 1.2, is_open: true, paper: theme.paper},
    made: {color: theme.made, width: 4.5},
    v: {color: theme.motion, width: 3},
    Fh: {color: theme.hand, width: 3},
    Fr: {color: theme.result, width: 3, dash: [7, 3]},
    normal: {color: theme.wanted, width: 2.2},
  })[id];

// The arc of gamma between the directions of F_d and the force of the brakes.
function draw_angle(pen, picture, labels, at, theme) {
  const [a, b] = picture.gamma.vectors.map(f => Math.atan2(...picture.camera.vector(f).reverse()));
  let turn = b - a;
  while (turn > Math.PI) turn -= 2 * Math.PI;
  while (turn < -Math.PI) turn += 2 * Math.PI;
  if (Math.abs(turn) < 0.02) return;
  const r = 46,
    points = [];
  for (let k = 0; k <= 16; ++k)
    points.push([at[0] + r * Math.cos(a + (turn * k) / 16), at[1] + r * Math.sin(a + (turn * k) / 16)]);
  pen.path(points_path(points), {stroke: theme.ink, width: 1.2});
  const side = a - 0.6 * Math.sign(turn), // where no other arrow is
    direction = [Math.cos(side), Math.sin(side)];
  labels.put(picture.gamma.text, at, direction, r + 4, {size: 14.5, math: true, color: theme.ink, halo: theme.paper});
}

// The area of the present motion, or one of others. In space only the first is shown.
export function draw_area(pen, {camera, force_scale}, at, {points, is_present, alpha}, theme) {
  const fill = {fill: is_present ? theme.cone : theme.faint, alpha},
    edge = is_present ? {stroke: theme.cone_line, width: 1.8} : {stroke: theme.faint, width: 1};
  if (camera.is_space) return draw_solid_cone(pen, camera, at, points, force_scale, fill);
  for (const style of [fill, edge]) draw_cone(pen, camera, at, points, force_scale, style);
}

// The number of a passive FME, in its middle.
export function name_cone(labels, picture, at, cone, theme) {
  const sum = cone.points.reduce((s, f) => plus(s, f), [0, 0, 0]),
    d = times((1.2 * picture.force_scale) / cone.points.length, picture.camera.vector(sum));
  if (cone.name && length_of(d) > 16)
    labels.put(cone.name, plus(at, d), [0, 1], -9, {
      size: cone.is_present ? 15 : 11.5,
      weight: cone.is_present ? 600 : 400,
      color: cone.is_present ? theme.cone_line : theme.muted,
      halo: theme.paper,
    });
}
