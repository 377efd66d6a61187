// The device as a person would sketch it: ground, links, joints, slides, pulleys, belts and brakes, from
// the rows that the engine computes. A brake is a disc that turns with its axis. Its ring is thin and
// dashed when it is released, amber when it slips, blue with a filled hub when it holds; the thicker the
// ring, the stronger the torque.

import {circle_path, line_path, points_path} from './pen.js';

const kinds = Object.fromEntries(
  'ground link joint slide carriage pulley belt brake platform handle'.split(' ').map((name, number) => [name, number]),
);
const row_length = 10;

// Rows of numbers as objects. point and other are [m].
export function drawing_rows(numbers, count) {
  const rows = [];
  for (let at = 0; at < count * row_length; at += row_length) {
    const [kind, number, ...rest] = numbers.subarray(at, at + row_length);
    rows.push({kind, number, point: rest.slice(0, 3), other: rest.slice(3, 6), size: rest[6], angle: rest[7]});
  }
  return rows;
}

export const handle_of = rows => rows.find(row => row.kind === kinds.handle)?.point;
const brake_rows = rows => rows.filter(row => row.kind === kinds.brake);

// brakes: for each {state: "released" | "slips" | "holds" | "no brake", share: 0 to 1, text}. look: {width
// of a link [pixels]}.
export function draw_device(pen, camera, rows, brakes, theme, look) {
  const order = camera.is_space
    ? rows
        .map(row => [drawing_layer(row) * 1e-3 + camera.depth(row_middle(row)), row])
        .sort((a, b) => a[0] - b[0])
        .map(pair => pair[1])
    : [...rows].sort((a, b) => drawing_layer(a) - drawing_layer(b));
  const all_look = {...look, enlarge: brake_enlargement(rows, camera)};
  for (const row of order) draw_row(pen, camera, row, brakes, theme, all_look);
}

const drawing_layer = row =>
  [0, 4, 6, 1, 3, 2.5, 2, 5, 4, 8][row.kind] - (row.kind === kinds.brake ? Math.min(0.9, row.size) : 0);
export const is_line_row = row =>
  row.kind === kinds.link || row.kind === kinds.slide || row.kind === kinds.belt || row.kind === kinds.platform;
const row_middle = row => (is_line_row(row) ? [0, 1, 2].map(i => (row.point[i] + row.other[i]) / 2) : row.point);

function draw_row(pen, camera, row, brakes, theme, look) {
  const at = camera.point(row.point),
    width = look.width;
  const paper = theme.metal;
  switch (row.kind) {
    case kinds.ground:
      return draw_ground(pen, at, Math.max(row.size * camera.scale, width), theme);
    case kinds.link:
    case kinds.platform: {
      const d = line_path(at, camera.point(row.other)),
        w = row.kind === kinds.link ? width : 0.6 * width;
      pen.path(d, {stroke: theme.ink, width: w});
      return pen.path(d, {stroke: paper, width: w - 2.6});
    }
    case kinds.joint:
      return pen.path(circle_path(at, 0.3 * width), {fill: theme.paper, stroke: theme.ink, width: 1.5});
    case kinds.slide: {
      const to = camera.point(row.other),
        across = unit_across(at, to).map(c => 0.28 * width * c),
        beside = (p, side) => p.map((c, i) => c + side * across[i]);
      for (const side of [-1, 1])
        pen.path(line_path(beside(at, side), beside(to, side)), {stroke: theme.muted, width: 1.8});
      for (const end of [at, to])
        pen.path(line_path(beside(end, -2), beside(end, 2)), {stroke: theme.muted, width: 2.4});
      return;
    }
    case kinds.carriage: {
      const to = camera.point([0, 1, 2].map(i => row.point[i] + row_axis(row)[i] / camera.scale)),
        b = unit_across(at, to),
        a = [b[1], -b[0]],
        corner = (s, t) => at.map((c, i) => c + width * (0.95 * s * a[i] + 0.62 * t * b[i]));
      const corners = [corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)];
      return pen.path(points_path(corners, true), {fill: paper, stroke: theme.ink, width: 1.5});
    }
    case kinds.pulley: {
      const r = Math.max(row.size, 6 / camera.scale),
        axis = row_axis(row);
      pen.path(ring_path(camera, row.point, axis, r), {fill: paper, stroke: theme.muted, width: 1.4});
      const mark = spokes_of(camera, row, r),
        d = [0, Math.PI / 2].map(f => line_path(mark(f, -0.75), mark(f, 0.75))).join('');
      return pen.path(d, {stroke: theme.muted, width: 1.1, alpha: 0.8});
    }
    case kinds.belt:
      return pen.path(line_path(at, camera.point(row.other)), {stroke: theme.muted, width: 1.6});
    case kinds.brake:
      return draw_brake(pen, camera, row, brakes[row.number], theme, look);
    case kinds.handle: {
      pen.path(circle_path(at, 0.62 * width), {fill: theme.paper, stroke: theme.ink, width: 2});
      return pen.path(circle_path(at, 0.3 * width), {fill: theme.ink});
    }
  }
}

// Points of a disc that turns with its axis, by angle and share of the radius.
function spokes_of(camera, row, r) {
  const [u, v] = across_axis(row_axis(row));
  return (f, s) =>
    camera.point(
      row.point.map((c, i) => c + s * r * (Math.cos(row.angle + f) * u[i] + Math.sin(row.angle + f) * v[i])),
    );
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
      here = all.filter(other => Math.hypot(...other.point.map((c, i) => c - row.point[i])) * camera.scale < 4),
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
      d = end.map((c, i) => c - at[i]),
      far = Math.hypot(...d) || 1,
      ring = (row.size * enlarge * camera.scale - 2) / far,
      from = at.map((c, i) => c + ring * d[i]);
    pen.path(
      line_path(
        from,
        end.map((c, i) => c - (3 * d[i]) / far),
      ),
      {stroke: color, width: 1.2},
    );
    pen.path(circle_path(from, 2.4), {fill: color});
  }
}

function draw_ground(pen, at, half, theme) {
  const depth = 0.5 * half,
    strokes = [];
  for (let k = 0; k <= 6; ++k) {
    const x = at[0] - half + (k * half) / 3;
    strokes.push(line_path([x, at[1] + 0.72 * half], [x - 0.4 * depth, at[1] + 0.72 * half + 0.6 * depth]));
  }
  pen.path(
    points_path([at, [at[0] + 0.62 * half, at[1] + 0.72 * half], [at[0] - 0.62 * half, at[1] + 0.72 * half]], true),
    {fill: theme.metal, stroke: theme.ink, width: 1.5},
  );
  pen.path(line_path([at[0] - half, at[1] + 0.72 * half], [at[0] + half, at[1] + 0.72 * half]) + strokes.join(''), {
    stroke: theme.muted,
    width: 1.4,
  });
}

// A circle about an axis in space, as it is seen.
function ring_path(camera, centre, axis, r) {
  const [u, v] = across_axis(axis),
    points = [];
  if (!camera.is_space) return circle_path(camera.point(centre), Math.max(0.1, r * camera.scale));
  for (let k = 0; k < 32; ++k) {
    const c = Math.cos((k * Math.PI) / 16),
      s = Math.sin((k * Math.PI) / 16);
    points.push(camera.point([0, 1, 2].map(i => centre[i] + r * (c * u[i] + s * v[i]))));
  }
  return points_path(points, true);
}

function row_axis(row) {
  const d = [0, 1, 2].map(i => row.other[i] - row.point[i]),
    length = Math.hypot(...d);
  return length > 0 ? d.map(c => c / length) : [0, 0, 1];
}

// Two unit vectors that span the plane across an axis; x and y for the axis z.
function across_axis(axis) {
  const start = Math.abs(axis[2]) > 0.9 ? [1, 0, 0] : [0, 0, 1];
  const along = start[0] * axis[0] + start[1] * axis[1] + start[2] * axis[2];
  const raw = [0, 1, 2].map(i => start[i] - along * axis[i]),
    length = Math.hypot(...raw),
    u = raw.map(c => c / length);
  return [u, [axis[1] * u[2] - axis[2] * u[1], axis[2] * u[0] - axis[0] * u[2], axis[0] * u[1] - axis[1] * u[0]]];
}

function unit_across(a, b) {
  const length = Math.hypot(b[0] - a[0], b[1] - a[1]) || 1;
  return [-(b[1] - a[1]) / length, (b[0] - a[0]) / length];
}
