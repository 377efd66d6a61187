// The device as a person would sketch it: ground, links, joints, slides, pulleys, belts and brakes, from
// the rows that the engine computes. A brake is a disc that turns with its axis. Its ring is thin and
// dashed when it is released, amber when it slips, blue with a filled hub when it holds; the thicker the
// ring, the stronger the torque.

import {circle_path, line_path, points_path} from './pen.js';

const kinds = {
  ground: 0,
  link: 1,
  joint: 2,
  slide: 3,
  carriage: 4,
  pulley: 5,
  belt: 6,
  brake: 7,
  platform: 8,
  handle: 9,
};
const row_length = 10;

// Rows of numbers as objects. point and other are [m].
export function drawing_rows(numbers, count) {
  const rows = [];
  for (let k = 0; k < count; ++k) {
    const at = k * row_length,
      row = numbers.subarray ? numbers.subarray(at, at + row_length) : numbers.slice(at, at + row_length);
    rows.push({
      kind: row[0],
      number: row[1],
      point: [row[2], row[3], row[4]],
      other: [row[5], row[6], row[7]],
      size: row[8],
      angle: row[9],
    });
  }
  return rows;
}

export const handle_of = rows => rows.find(row => row.kind === kinds.handle)?.point;
export const brake_rows = rows => rows.filter(row => row.kind === kinds.brake);

// brakes: for each {state: "released" | "slips" | "holds" | "no brake", share: 0 to 1, text}. look: {width
// of a link [pixels], is_ghost, labels}.
export function draw_device(pen, camera, rows, brakes, theme, look) {
  const order = camera.is_space
    ? rows
        .map(row => [drawing_layer(row) * 1e-3 + camera.depth(row_middle(row)), row])
        .sort((a, b) => a[0] - b[0])
        .map(pair => pair[1])
    : [...rows].sort((a, b) => drawing_layer(a) - drawing_layer(b));
  const all_look = {...look, enlarge: brake_enlargement(rows, camera)};
  for (const row of order) draw_row(pen, camera, row, brakes, theme, all_look);
  if (look.labels) label_brakes(pen, camera, rows, brakes, theme, all_look.enlarge);
}

const drawing_layer = row =>
  [0, 4, 6, 1, 3, 2.5, 2, 5, 4, 8][row.kind] - (row.kind === kinds.brake ? Math.min(0.9, row.size) : 0);
export const is_line_row = row =>
  row.kind === kinds.link ||
  row.kind === kinds.slide ||
  row.kind === kinds.belt ||
  row.kind === kinds.platform;
const row_middle = row =>
  is_line_row(row) ? [0, 1, 2].map(i => (row.point[i] + row.other[i]) / 2) : row.point;

function draw_row(pen, camera, row, brakes, theme, look) {
  const at = camera.point(row.point),
    width = look.width;
  const paper = look.is_ghost ? 'none' : theme.metal;
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
    case kinds.joint: {
      pen.path(circle_path(at, 0.3 * width), {fill: theme.paper, stroke: theme.ink, width: 1.5});
      return;
    }
    case kinds.slide: {
      const to = camera.point(row.other),
        across = unit_across(at, to),
        gap = 0.28 * width;
      for (const side of [-gap, gap])
        pen.path(
          line_path(
            [at[0] + side * across[0], at[1] + side * across[1]],
            [to[0] + side * across[0], to[1] + side * across[1]],
          ),
          {stroke: theme.muted, width: 1.8},
        );
      for (const end of [at, to])
        pen.path(
          line_path(
            [end[0] - 2 * gap * across[0], end[1] - 2 * gap * across[1]],
            [end[0] + 2 * gap * across[0], end[1] + 2 * gap * across[1]],
          ),
          {stroke: theme.muted, width: 2.4},
        );
      return;
    }
    case kinds.carriage: {
      const to = camera.point([0, 1, 2].map(i => row.point[i] + row_axis(row)[i] / camera.scale));
      const along = [to[0] - at[0], to[1] - at[1]],
        length = Math.hypot(...along) || 1,
        a = along.map(c => c / length),
        b = [-a[1], a[0]];
      const corner = (s, t) => [
        at[0] + 0.95 * width * s * a[0] + 0.62 * width * t * b[0],
        at[1] + 0.95 * width * s * a[1] + 0.62 * width * t * b[1],
      ];
      return pen.path(points_path([corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)], true), {
        fill: paper,
        stroke: theme.ink,
        width: 1.5,
      });
    }
    case kinds.pulley: {
      const r = Math.max(row.size, 6 / camera.scale),
        axis = row_axis(row);
      pen.path(ring_path(camera, row.point, axis, r), {fill: paper, stroke: theme.muted, width: 1.4});
      const [u, v] = across_axis(axis),
        mark = (f, s) =>
          camera.point(
            [0, 1, 2].map(
              i => row.point[i] + s * r * (Math.cos(row.angle + f) * u[i] + Math.sin(row.angle + f) * v[i]),
            ),
          );
      return pen.path([0, Math.PI / 2].map(f => line_path(mark(f, -0.75), mark(f, 0.75))).join(''), {
        stroke: theme.muted,
        width: 1.1,
        alpha: 0.8,
      });
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

function draw_brake(pen, camera, row, state, theme, look) {
  if (!state || state.state === 'no brake') return;
  const r = row.size * look.enlarge,
    axis = row_axis(row),
    [u, v] = across_axis(axis);
  const color = theme[state.state] || theme.released,
    strength = Math.min(1, Math.max(0, state.share || 0));
  const is_working = state.state !== 'released';
  pen.path(ring_path(camera, row.point, axis, r), {
    fill: theme.paper,
    stroke: theme.ink,
    width: 1.2,
    alpha: look.is_ghost ? 0.4 : 1,
  });
  const spoke = (f, s) =>
    camera.point(
      [0, 1, 2].map(
        i => row.point[i] + s * r * (Math.cos(row.angle + f) * u[i] + Math.sin(row.angle + f) * v[i]),
      ),
    );
  pen.path([0, 1, 2].map(k => line_path(spoke(2.0944 * k, 0.36), spoke(2.0944 * k, 0.7))).join(''), {
    stroke: theme.muted,
    width: 1.8,
  });
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

function label_brakes(pen, camera, rows, brakes, theme, enlarge) {
  const all = brake_rows(rows),
    handle_at = camera.point(handle_of(rows));
  const centre = [0, 1].map(i => all.reduce((sum, row) => sum + camera.point(row.point)[i], 0) / all.length);
  for (const row of all) {
    const state = brakes[row.number];
    if (!state || state.state === 'no brake') continue;
    const at = camera.point(row.point),
      here = all.filter(
        other => Math.hypot(...other.point.map((c, i) => c - row.point[i])) * camera.scale < 4,
      ),
      shares = here.length > 1;
    const r = Math.max(...here.map(other => other.size)) * enlarge * camera.scale;
    const room = 7 * state.text.length + r + 12; // of the text [pixels], about
    const is_left =
      at[0] + room > pen.width ||
      (at[0] > room &&
        (shares
          ? row.number % 2 === 1
          : all.length > 1 && (at[0] < centre[0] - 1 || is_beside(at, handle_at))));
    const x = at[0] + (is_left ? -1 : 1) * (r + 7),
      align = is_left ? 'end' : 'start';
    pen.label('brake ' + (row.number + 1), x, at[1] - 2, {
      size: 12,
      color: theme.muted,
      align,
      halo: theme.paper,
    });
    pen.label(state.text, x, at[1] + 13, {
      size: 12,
      weight: 600,
      color: state.state === 'released' ? theme.muted : theme[state.state + '_text'] || theme.ink,
      align,
      halo: theme.paper,
    });
  }
}

// Whether a label to the right of a brake would lie on the handle.
const is_beside = (at, handle_at) =>
  handle_at[0] > at[0] - 4 && handle_at[0] < at[0] + 110 && Math.abs(handle_at[1] - at[1]) < 34;

function draw_ground(pen, at, half, theme) {
  const depth = 0.5 * half,
    strokes = [];
  for (let k = 0; k <= 6; ++k) {
    const x = at[0] - half + (k * half) / 3;
    strokes.push(line_path([x, at[1] + 0.72 * half], [x - 0.4 * depth, at[1] + 0.72 * half + 0.6 * depth]));
  }
  pen.path(
    points_path(
      [at, [at[0] + 0.62 * half, at[1] + 0.72 * half], [at[0] - 0.62 * half, at[1] + 0.72 * half]],
      true,
    ),
    {fill: theme.metal, stroke: theme.ink, width: 1.5},
  );
  pen.path(
    line_path([at[0] - half, at[1] + 0.72 * half], [at[0] + half, at[1] + 0.72 * half]) + strokes.join(''),
    {stroke: theme.muted, width: 1.4},
  );
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
  return [
    u,
    [axis[1] * u[2] - axis[2] * u[1], axis[2] * u[0] - axis[0] * u[2], axis[0] * u[1] - axis[1] * u[0]],
  ];
}

function unit_across(a, b) {
  const length = Math.hypot(b[0] - a[0], b[1] - a[1]) || 1;
  return [-(b[1] - a[1]) / length, (b[0] - a[0]) / length];
}
