// Forces and velocities at the handle: cones, reference forces, arrows, and the angle gamma.

import {draw_arrow, draw_cone, draw_solid_cone, label_arrow} from './arrows.js';
import {points_path} from './pen.js';

export const max_arrow = 0.36; // of the smaller side of the picture; longer ones are cut [1]

export function draw_forces(pen, picture, at, theme) {
  const {camera, shown} = picture,
    most = max_arrow * Math.min(pen.width, pen.height);
  const pixels_of = (vector, scale) => camera.vector(vector).map(c => c * scale);
  if (shown.has('references'))
    for (const reference of picture.references) {
      const head = draw_arrow(
        pen,
        at,
        pixels_of(reference.vector, picture.force_scale),
        {color: theme.muted, width: 1.3, dash: [5, 4]},
        most,
      );
      if (Math.hypot(head[0] - at[0], head[1] - at[1]) > 24)
        label_arrow(pen, at, head, reference.label, {color: theme.muted, halo: theme.paper, size: 13.5});
    }
  const labels = [];
  for (const arrow of picture.arrows) {
    if (!shown.has(arrow.layer)) continue;
    const d = pixels_of(arrow.vector, arrow.is_motion ? picture.motion_scale : picture.force_scale),
      style = arrow_style(arrow.id, theme);
    const head = draw_arrow(pen, at, d, style, most);
    arrow.head = Math.hypot(...d) > 1 ? head : null;
    if (arrow.head && Math.hypot(head[0] - at[0], head[1] - at[1]) > 12) labels.push([head, arrow, style]);
  }
  const taken = [];
  for (const [head, arrow, style] of labels) {
    let place = head;
    // Labels of arrows that end at one place stand below each other.
    while (taken.some(other => Math.abs(other[0] - place[0]) < 26 && Math.abs(other[1] - place[1]) < 17))
      place = [place[0], place[1] + 17];
    taken.push(place);
    label_arrow(pen, at, place, arrow.label, {
      color: style.color,
      halo: theme.paper,
      weight: 600,
      size: 16.5,
    });
  }
  if (picture.gamma && shown.has('made')) draw_angle(pen, picture, at, theme);
}

export function arrow_style(id, theme) {
  return {
    Fd: {color: theme.wanted, width: 2.2},
    without_law: {color: theme.made, width: 8, alpha: 0.3},
    displayed: {color: theme.made, width: 4.5},
    v: {color: theme.motion, width: 3},
    Fh: {color: theme.hand, width: 3},
    Fr: {color: theme.result, width: 2, dash: [7, 3]},
    brake_force: {color: theme.made, width: 4.5},
  }[id];
}

// The arc of gamma between the directions of F_d and F_c.
function draw_angle(pen, picture, at, theme) {
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
  const middle = a - 0.34 * Math.sign(turn); // beside F_d, where no other arrow is
  pen.label(
    picture.gamma.text,
    at[0] + (r + 14) * Math.cos(middle),
    at[1] + (r + 14) * Math.sin(middle) + 5,
    {
      size: 14.5,
      math: true,
      align: Math.cos(middle) > 0.3 ? 'start' : Math.cos(middle) < -0.3 ? 'end' : 'middle',
      color: theme.ink,
      halo: theme.paper,
    },
  );
}

export function fill_cone(pen, picture, at, cone, theme) {
  const {camera, force_scale} = picture;
  if (camera.is_space)
    return draw_solid_cone(pen, camera, at, cone.points, force_scale, {fill: theme.cone, alpha: 0.3});
  draw_cone(pen, camera, at, cone.points, force_scale, {fill: theme.cone, alpha: 0.3});
  draw_cone(pen, camera, at, cone.points, force_scale, {stroke: theme.cone_line, width: 1.8});
}

export function outline_cone(pen, picture, at, cone, theme) {
  const {camera, force_scale} = picture;
  if (camera.is_space)
    return draw_solid_cone(pen, camera, at, cone.points, force_scale, {fill: theme.faint, alpha: 0.1});
  draw_cone(pen, camera, at, cone.points, force_scale, {fill: theme.faint, alpha: cone.alpha});
  draw_cone(pen, camera, at, cone.points, force_scale, {stroke: theme.faint, width: 1});
  const sum = cone.points.reduce((s, f) => [s[0] + f[0], s[1] + f[1]], [0, 0]),
    size = Math.hypot(...sum) || 1;
  const far = Math.max(...cone.points.map(f => (f[0] * sum[0] + f[1] * sum[1]) / size));
  const d = camera.vector([sum[0] / size, sum[1] / size]).map(c => c * 0.62 * far * force_scale);
  if (cone.name && Math.hypot(...d) > 26)
    pen.label(cone.name, at[0] + d[0], at[1] + d[1] + 4, {size: 11.5, align: 'middle', color: theme.muted});
}
