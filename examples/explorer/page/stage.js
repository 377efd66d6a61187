// The picture: walls, device, forces, hand and paths, in the order in which they lie over each other.

import { draw_arrow, draw_cone, draw_solid_cone, draw_spring, label_arrow } from './arrows.js';
import { circle_path, line_path, points_path } from './pen.js';
import { draw_device } from './sketch.js';
import { draw_walls } from './walls.js';

export const longest_arrow = 0.36;  // of the smaller side of the picture; longer ones are cut [1]

// picture: {camera, walls, rows, brakes, handle, cones: [{points, is_present, name}], arrows: [{id, vector, label, is_force}],
// references: [{vector, label}], force_scale, motion_scale [pixels per N, per m/s], paths: [{points, color}], others: [{point, color}],
// pointer, map, lens, shown: Set of layers, gamma: {from, to, text}}.
export function draw_stage(pen, picture, theme) {
  const {camera, handle, shown} = picture, small = pen.width < 520;
  const at = handle && camera.point(handle), link_width = small ? 11 : 15;
  if (picture.map && !camera.is_space) draw_map(pen, picture, theme);
  draw_walls(pen, camera, picture.walls, theme, picture.is_hollow, 18);
  if (picture.map && camera.is_space) draw_map(pen, picture, theme);
  if (camera.is_space) draw_floor(pen, picture, theme);
  draw_scale(pen, camera, theme);
  if (at && shown.has("others")) for (const cone of picture.cones) if (!cone.is_present) outline_cone(pen, picture, at, cone, theme);
  if (at && shown.has("cone") && !camera.is_space) for (const cone of picture.cones) if (cone.is_present) fill_cone(pen, picture, at, cone, theme);
  draw_device(pen, camera, picture.rows, picture.brakes, theme, {width: link_width, labels: shown.has("brakes")});
  if (at && shown.has("cone") && camera.is_space) for (const cone of picture.cones) if (cone.is_present) fill_cone(pen, picture, at, cone, theme);
  for (const path of picture.paths) pen.curve([path.points.flatMap(camera.point)], {stroke: path.color, width: 2, alpha: 0.8});
  for (const other of picture.others) pen.path(circle_path(camera.point(other.point), small ? 4.5 : 6), {fill: other.color, stroke: theme.paper, width: 1.5});
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

function draw_forces(pen, picture, at, theme) {
  const {camera, shown} = picture, most = longest_arrow * Math.min(pen.width, pen.height);
  const pixels_of = (vector, scale) => camera.vector(vector).map(c => c * scale);
  if (shown.has("references")) for (const reference of picture.references) {
    const head = draw_arrow(pen, at, pixels_of(reference.vector, picture.force_scale), {color: theme.muted, width: 1.3, dash: [5, 4]}, most);
    if (Math.hypot(head[0] - at[0], head[1] - at[1]) > 24) label_arrow(pen, at, head, reference.label, {color: theme.muted, halo: theme.paper, size: 13.5});
  }
  const labels = [];
  for (const arrow of picture.arrows) {
    if (!shown.has(arrow.layer)) continue;
    const d = pixels_of(arrow.vector, arrow.is_motion ? picture.motion_scale : picture.force_scale), style = arrow_style(arrow.id, theme);
    const head = draw_arrow(pen, at, d, style, most);
    arrow.head = Math.hypot(...d) > 1 ? head : null;
    if (arrow.head && Math.hypot(head[0] - at[0], head[1] - at[1]) > 12) labels.push([head, arrow, style]);
  }
  const taken = [];
  for (const [head, arrow, style] of labels) {
    let place = head;
    // Labels of arrows that end at one place stand below each other.
    while (taken.some(other => Math.abs(other[0] - place[0]) < 26 && Math.abs(other[1] - place[1]) < 17)) place = [place[0], place[1] + 17];
    taken.push(place);
    label_arrow(pen, at, place, arrow.label, {color: style.color, halo: theme.paper, weight: 600, size: 16.5});
  }
  if (picture.gamma && shown.has("made")) draw_angle(pen, picture, at, theme);
}

export function arrow_style(id, theme) {
  return {
    Fd: {color: theme.wanted, width: 2.2}, Fp: {color: theme.made, width: 1.6, dash: [4, 3]}, Fc: {color: theme.made, width: 8, alpha: 0.3},
    Fc_scaled: {color: theme.made, width: 4.5}, v: {color: theme.motion, width: 3}, Fh: {color: theme.hand, width: 3},
    Fr: {color: theme.result, width: 2, dash: [7, 3]}, brake_force: {color: theme.made, width: 4.5},
  }[id];
}

// The arc of gamma between the directions of F_d and F_c.
function draw_angle(pen, picture, at, theme) {
  const [a, b] = picture.gamma.vectors.map(f => Math.atan2(...picture.camera.vector(f).reverse()));
  let turn = b - a;
  while (turn > Math.PI) turn -= 2 * Math.PI;
  while (turn < -Math.PI) turn += 2 * Math.PI;
  if (Math.abs(turn) < 0.02) return;
  const r = 46, points = [];
  for (let k = 0; k <= 16; ++k) points.push([at[0] + r * Math.cos(a + turn * k / 16), at[1] + r * Math.sin(a + turn * k / 16)]);
  pen.path(points_path(points), {stroke: theme.ink, width: 1.2});
  const middle = a - 0.34 * Math.sign(turn);  // beside F_d, where no other arrow is
  pen.label(picture.gamma.text, at[0] + (r + 14) * Math.cos(middle), at[1] + (r + 14) * Math.sin(middle) + 5,
    {size: 14.5, math: true, align: Math.cos(middle) > 0.3 ? "start" : Math.cos(middle) < -0.3 ? "end" : "middle", color: theme.ink, halo: theme.paper});
}

function fill_cone(pen, picture, at, cone, theme) {
  const {camera, force_scale} = picture;
  if (camera.is_space) return draw_solid_cone(pen, camera, at, cone.points, force_scale, {fill: theme.cone, alpha: 0.3});
  draw_cone(pen, camera, at, cone.points, force_scale, {fill: theme.cone, alpha: 0.3});
  draw_cone(pen, camera, at, cone.points, force_scale, {stroke: theme.cone_line, width: 1.8});
}

function outline_cone(pen, picture, at, cone, theme) {
  const {camera, force_scale} = picture;
  if (camera.is_space) return draw_solid_cone(pen, camera, at, cone.points, force_scale, {fill: theme.faint, alpha: 0.1});
  draw_cone(pen, camera, at, cone.points, force_scale, {fill: theme.faint, alpha: cone.alpha});
  draw_cone(pen, camera, at, cone.points, force_scale, {stroke: theme.faint, width: 1});
  const sum = cone.points.reduce((s, f) => [s[0] + f[0], s[1] + f[1]], [0, 0]), size = Math.hypot(...sum) || 1;
  const far = Math.max(...cone.points.map(f => (f[0] * sum[0] + f[1] * sum[1]) / size));
  const d = camera.vector([sum[0] / size, sum[1] / size]).map(c => c * 0.62 * far * force_scale);
  if (cone.name && Math.hypot(...d) > 26) pen.label(cone.name, at[0] + d[0], at[1] + d[1] + 4, {size: 11.5, align: "middle", color: theme.muted});
}

// A hand that holds the handle: the thumb and a finger, seen from above.
function draw_hand(pen, at, theme, size) {
  const c = Math.cos(-0.62), s = Math.sin(-0.62);  // the arm comes from the lower right
  const p = (x, y) => (at[0] + size * (c * x - s * y)).toFixed(1) + " " + (at[1] + size * (s * x + c * y)).toFixed(1);
  const fingers = [[[-9, -3], [-17, 20]], [[-2, -10], [-6, 20]], [[7, -8], [6, 22]], [[13, 1], [14, 28]]];
  pen.path(`M${p(-21, 20)}C${p(-24, 40)} ${p(-14, 56)} ${p(-13, 92)}L${p(17, 92)}C${p(17, 62)} ${p(25, 44)} ${p(19, 24)}C${p(8, 12)} ${p(-12, 10)} ${p(-21, 20)}Z`, {fill: theme.hand, alpha: 0.24});
  pen.path(fingers.map(([tip, root]) => `M${p(...tip)}L${p(...root)}`).join(""), {stroke: theme.hand, width: 9 * size, alpha: 0.3});
}

// A bar of a round length.
function draw_scale(pen, camera, theme) {
  const length = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2].findLast(l => l * camera.scale < 0.22 * pen.width) || 0.01;
  const x = 18, y = pen.height - 18, end = x + length * camera.scale;
  pen.path(`M${x} ${y - 4}V${y}H${end}V${y - 4}`, {stroke: theme.muted, width: 1.4, cap: "butt"});
  pen.label(length < 1 ? 100 * length + " cm" : length + " m", (x + end) / 2, y - 5, {size: 12, align: "middle", color: theme.muted});
}

// A grid on the floor of the space that the device reaches, so that turning it is seen.
function draw_floor(pen, picture, theme) {
  const [x0, y0, z0, x1, y1] = picture.bounds, lines = [], count = 6;
  for (let k = 0; k <= count; ++k) {
    const x = x0 + (x1 - x0) * k / count, y = y0 + (y1 - y0) * k / count;
    lines.push(line_path(picture.camera.point([x, y0, z0]), picture.camera.point([x, y1, z0])), line_path(picture.camera.point([x0, y, z0]), picture.camera.point([x1, y, z0])));
  }
  pen.path(lines.join(""), {stroke: theme.faint, width: 0.7, alpha: 0.7});
  const axes = [[[1, 0, 0], "x"], [[0, 1, 0], "y"], [[0, 0, 1], "z"]], from = [42, pen.height - 64];
  for (const [axis, name] of axes) {
    const d = picture.camera.vector(axis).map(c => 26 * c), head = [from[0] + d[0], from[1] + d[1]];
    pen.path(line_path(from, head), {stroke: theme.muted, width: 1.4});
    pen.label(name, from[0] + 1.35 * d[0], from[1] + 1.35 * d[1] + 4, {size: 13, math: true, align: "middle", color: theme.muted});
  }
  if (picture.handle) {
    const foot = [picture.handle[0], picture.handle[1], z0];
    pen.path(line_path(picture.camera.point(picture.handle), picture.camera.point(foot)), {stroke: theme.muted, width: 1, dash: [2, 4]});
  }
}

// The design map, painted under the mechanism, and what its colours mean.
function draw_map(pen, picture, theme) {
  const {map, camera} = picture, z = picture.handle ? picture.handle[2] : 0, corner = (x, y) => camera.point([x, y, z]);
  pen.image(map.image, corner(map.low[0], map.high[1]), corner(map.high[0], map.high[1]), corner(map.low[0], map.low[1]), 0.85);
  const width = 150, x = pen.width - width - 18, y = pen.height - 30;
  map.ramp.forEach((color, k) => pen.path(`M${x + width * k / map.ramp.length} ${y}h${width / map.ramp.length + 0.5}v9h${-width / map.ramp.length - 0.5}Z`, {fill: color}));
  pen.label(map.texts[0], x, y + 23, {size: 12, color: theme.muted, halo: theme.paper});
  pen.label(map.texts[1], x + width, y + 23, {size: 12, align: "end", color: theme.muted, halo: theme.paper});
  pen.label(map.title, x + width, y - 7, {size: 12.5, align: "end", color: theme.ink, halo: theme.paper});
}

// A magnifying glass over the handles at the wall.
function draw_lens(pen, picture, theme) {
  const {lens} = picture, r = lens.radius, on_stage = picture.camera.point(lens.centre), small_r = r / lens.times;
  const d = [lens.at[0] - on_stage[0], lens.at[1] - on_stage[1]], length = Math.hypot(...d) || 1;
  pen.path(circle_path(on_stage, Math.max(small_r, 9)), {stroke: theme.muted, width: 1.2});
  pen.path(line_path([on_stage[0] + Math.max(small_r, 9) * d[0] / length, on_stage[1] + Math.max(small_r, 9) * d[1] / length], [lens.at[0] - r * d[0] / length, lens.at[1] - r * d[1] / length]), {stroke: theme.muted, width: 1.2, dash: [3, 4]});
  pen.path(circle_path(lens.at, r), {fill: theme.paper});
  pen.clip(circle_path(lens.at, r), () => {
    draw_walls(pen, lens.camera, lens.walls, theme, picture.is_hollow, 3 * r);
    for (const path of picture.paths) pen.curve([path.points.flatMap(lens.camera.point)], {stroke: path.color, width: 2.4});
    for (const other of [...picture.others, ...(picture.focus ? [picture.focus] : [])])
      pen.path(circle_path(lens.camera.point(other.point), 8), {fill: other.color, stroke: theme.paper, width: 2});
  });
  pen.path(circle_path(lens.at, r), {stroke: theme.ink, width: 2});
  pen.label(lens.times + " × larger", lens.at[0], lens.at[1] + r + 17, {size: 12, align: "middle", color: theme.muted, halo: theme.paper});
}
