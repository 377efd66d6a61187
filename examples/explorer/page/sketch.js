// The device as a person would sketch it: ground, links, joints, slides, pulleys, belts and brakes, from
// the rows that the engine computes. A brake is a disc that turns with its axis. Its ring is thin and
// dashed when it is released, amber when it slips, blue with a filled hub when it holds; the thicker the
// ring, the stronger the torque.

import {circle_path, line_path, points_path} from './pen.js';
import {cross, dot, frame_at, length_of, minus, plus, times, unit} from './vectors.js';

const kinds = 'ground link joint slide carriage pulley belt brake platform handle'.split(' '); // as in drawing.hpp
const drawing_layers = [0, 4, 6, 1, 3, 2.5, 2, 5, 4, 8]; // of these kinds: a higher one is drawn over a lower one
const numbers_of_a_row = 10;

// Rows of numbers as objects. point and other are [m].
export function drawing_rows(numbers) {
  const rows = [];
  for (let at = 0; at < numbers.length; at += numbers_of_a_row) {
    const [kind, number, ...rest] = numbers.subarray(at, at + numbers_of_a_row);
    rows.push({
      kind: kinds[kind],
      number,
      point: rest.slice(0, 3),
      other: rest.slice(3, 6),
      size: rest[6],
      angle: rest[7],
    });
  }
  return rows;
}

export const handle_of = rows => rows.find(row => row.kind === 'handle')?.point;
const brake_rows = rows => rows.filter(row => row.kind === 'brake');

// brakes: for each {state: "released" | "slips" | "holds" | "no brake", share: 0 to 1, text}. look: {width
// of a link [pixels]}.
export function draw_device(pen, camera, rows, brakes, theme, look) {
  const layer = ({kind, size}) => drawing_layers[kinds.indexOf(kind)] - (kind === 'brake' ? Math.min(0.9, size) : 0),
    height = row => layer(row) * 1e-3 + camera.depth(row_middle(row)),
    all_look = {...look, enlarge: brake_enlargement(rows, camera)};
  for (const row of [...rows].sort((a, b) => height(a) - height(b)))
    draw_row(pen, camera, row, brakes, theme, all_look);
}

export const is_line_row = row => ['link', 'slide', 'belt', 'platform'].includes(row.kind);
const row_middle = row => (is_line_row(row) ? times(0.5, plus(row.point, row.other)) : row.point);

function draw_row(pen, camera, row, brakes, theme, look) {
  const at = camera.point(row.point),
    {width} = look,
    paper = theme.metal;
  switch (row.kind) {
    case 'ground':
      return draw_ground(pen, at, Math.max(row.size * camera.scale, width), theme);
    case 'link':
    case 'platform': {
      const d = line_path(at, camera.point(row.other)),
        w = row.kind === 'link' ? width : 0.6 * width;
      pen.path(d, {stroke: theme.ink, width: w});
      return pen.path(d, {stroke: paper, width: w - 2.6});
    }
    case 'joint':
      return pen.path(circle_path(at, 0.3 * width), {fill: theme.paper, stroke: theme.ink, width: 1.5});
    case 'slide': {
      const along = minus(camera.point(row.other), at),
        to = length_of(along),
        on = frame_at(at, along),
        half = 0.28 * width;
      for (const side of [-half, half])
        pen.path(line_path(on(0, side), on(to, side)), {stroke: theme.muted, width: 1.8});
      for (const end of [0, to])
        pen.path(line_path(on(end, -2 * half), on(end, 2 * half)), {stroke: theme.muted, width: 2.4});
      return;
    }
    case 'carriage': {
      const corner = frame_at(at, camera.vector(row_axis(row))),
        [s, t] = [0.95 * width, 0.62 * width],
        corners = [corner(-s, -t), corner(s, -t), corner(s, t), corner(-s, t)];
      return pen.path(points_path(corners, true), {fill: paper, stroke: theme.ink, width: 1.5});
    }
    case 'pulley': {
      const r = Math.max(row.size, 6 / camera.scale),
        axis = row_axis(row);
      pen.path(ring_path(camera, row.point, axis, r), {fill: paper, stroke: theme.muted, width: 1.4});
      const mark = spokes_of(camera, row, r),
        d = [0, Math.PI / 2].map(f => line_path(mark(f, -0.75), mark(f, 0.75))).join('');
      return pen.path(d, {stroke: theme.muted, width: 1.1, alpha: 0.8});
    }
    case 'belt':
      return pen.path(line_path(at, camera.point(row.other)), {stroke: theme.muted, width: 1.6});
    case 'brake':
      return draw_brake(pen, camera, row, brakes[row.number], theme, look);
    case 'handle': {
      pen.path(circle_path(at, 0.62 * width), {fill: theme.paper, stroke: theme.ink, width: 2});
      return pen.path(circle_path(at, 0.3 * width), {fill: theme.ink});
    }
  }
}

// Points of a disc that turns with its axis, by angle and share of the radius.
function spokes_of(camera, row, r) {
  const on = circle_about(row.point, row_axis(row));
  return (f, s) => camera.point(on(row.angle + f, s * r));
}

function draw_brake(pen, camera, row, state, theme, look) {
  if (!state || state.state === 'no brake') return;
  const r = row.size * look.enlarge,
    axis = row_axis(row);
  const color = theme[state.state] || theme.released,
    strength = Math.min(1, Math.max(0, state.share || 0));
  const is_working = state.state !== 'released';
  pen.path(ring_path(camera, row.point, axis, r), {fill: theme.paper, stroke: theme.ink, width: 1.2});
  const spoke = spokes_of(camera, row, r),
    d = [0, 1, 2].map(k => line_path(spoke(2.0944 * k, 0.36), spoke(2.0944 * k, 0.7))).join('');
  pen.path(d, {stroke: theme.muted, width: 1.8});
  const width = is_working ? 2 + 0.42 * r * camera.scale * strength : 1.6;
  pen.path(ring_path(camera, row.point, axis, r - (0.5 * width) / camera.scale), {
    stroke: color,
    width,
    dash: is_working ? [] : [3, 4],
    cap: 'butt',
  });
  pen.path(ring_path(camera, row.point, axis, 0.3 * r), {
    fill: state.state === 'holds' ? color : theme.paper,
    stroke: is_working ? color : theme.muted,
    width: 1.6,
  });
}

// All brakes are drawn larger by one factor where the smallest would be too small to be seen.
function brake_enlargement(rows, camera) {
  const least = Math.min(...brake_rows(rows).map(row => row.size * camera.scale));
  return Number.isFinite(least) && least > 0 ? Math.max(1, min_brake_radius / least) : 1;
}

const min_brake_radius = 11; // radius [pixels]

// Names each brake, with a line from its ring to the label, as rings may have one centre.
export function label_brakes(pen, labels, camera, rows, brakes, theme) {
  const all = brake_rows(rows),
    enlarge = brake_enlargement(rows, camera),
    middle = [0, 1].map(i => all.reduce((sum, row) => sum + camera.point(row.point)[i] / all.length, 0));
  for (const row of all) {
    const state = brakes[row.number];
    if (!state || state.state === 'no brake') continue;
    const at = camera.point(row.point),
      here = all.filter(other => length_of(minus(other.point, row.point)) * camera.scale < 4),
      outer = Math.max(...here.map(other => other.size)) * enlarge * camera.scale,
      is_left = here.length > 1 ? row.number % 2 === 1 : at[0] < middle[0] - 1,
      color = state.state === 'released' ? theme.muted : theme[state.state + '_text'] || theme.ink;
    const box = labels.put(`brake ${row.number + 1}: ${state.text}`, at, [is_left ? -1 : 1, 0], outer + 10, {
      size: 12.5,
      weight: 600,
      color,
      halo: theme.paper,
    });
    const end = [Math.min(box[0] + box[2], Math.max(box[0] - box[2], at[0])), box[1]],
      d = minus(end, at),
      on = frame_at(at, d),
      from = on(row.size * enlarge * camera.scale - 2);
    pen.path(line_path(from, on(length_of(d) - 3)), {stroke: color, width: 1.2});
    pen.path(circle_path(from, 2.4), {fill: color});
  }
}

function draw_ground(pen, at, half, theme) {
  const corner = (s, t) => plus(at, [s * half, t * half]),
    strokes = [0, 1, 2, 3, 4, 5, 6].map(k => line_path(corner(k / 3 - 1, 0.72), corner(k / 3 - 1.2, 1.02)));
  pen.path(points_path([at, corner(0.62, 0.72), corner(-0.62, 0.72)], true), {
    fill: theme.metal,
    stroke: theme.ink,
    width: 1.5,
  });
  pen.path(line_path(corner(-1, 0.72), corner(1, 0.72)) + strokes.join(''), {stroke: theme.muted, width: 1.4});
}

// A circle about an axis in space, as it is seen.
function ring_path(camera, centre, axis, r) {
  if (!camera.is_space) return circle_path(camera.point(centre), Math.max(0.1, r * camera.scale));
  const on = circle_about(centre, axis),
    points = Array.from({length: 32}, (_, k) => camera.point(on((k * Math.PI) / 16, r)));
  return points_path(points, true);
}

const row_axis = row => (length_of(minus(row.other, row.point)) > 0 ? unit(minus(row.other, row.point)) : [0, 0, 1]);

// Points about a centre in the plane across an axis, by angle and radius; from x to y for the axis z.
function circle_about(centre, axis) {
  const start = Math.abs(axis[2]) > 0.9 ? [1, 0, 0] : [0, 0, 1],
    u = unit(plus(start, axis, -dot(start, axis))),
    v = cross(axis, u);
  return (angle, r) => plus(plus(centre, u, r * Math.cos(angle)), v, r * Math.sin(angle));
}
