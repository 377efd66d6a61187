// The picture of the present state, as stage.js draws it: what the engine computed, with scales and a
// camera.

import {fitting_camera, plane_camera} from './camera.js';
import {max_arrow} from './forces.js';
import {degrees, short_number} from './format.js';
import {each_point} from './tracks.js';
import {drawing_rows, handle_of, is_line_row} from './sketch.js';

const cone_share = 0.36; // of the smaller side of the picture: the strongest force that the brakes make [1]
const view_share = {still: 0.13, moving: 0.075, space: 0.06}; // of the reach, around the device at its first place [1]
const motion_share = 0.13; // of the smaller side: the velocity at first [1]
const trail_seconds = 1.6; // of the paths of the hands
const lens_times = 10; // enlargement of the lens
const lens_rise = 0.06; // how fast the lens follows [1 a picture]

// The scales of a device, which stay while it moves: pixels for a newton and for a metre a second, at a
// picture of size 1.
export function scales_of(device, info) {
  let strongest = 0;
  for (let region = 0; region < 1 << info.brakes; ++region)
    for (const force of device.outline(region, true))
      if (force.every(Number.isFinite)) strongest = Math.max(strongest, Math.hypot(...force));
  const bounds = device.bounds(),
    reach = Math.max(bounds[3] - bounds[0], bounds[4] - bounds[1], bounds[5] - bounds[2]);
  const speed = Math.hypot(...device.value('v'));
  // Where a brake alone makes no force (n > d): what all make together, or would at half of the reach.
  if (!strongest)
    for (const force of device.outline(-1, true))
      if (force.every(Number.isFinite)) strongest = Math.max(strongest, Math.hypot(...force));
  if (!strongest)
    strongest = (2 * device.value('torque_limit').reduce((sum, limit) => sum + limit, 0)) / reach;
  return {
    force: ((info.dimension === 3 ? 0.7 : 1) * cone_share) / (strongest || 1),
    motion: speed > 0 ? motion_share / speed : 1.1 / (reach || 1),
    reach,
  };
}

// The box that the picture shows of a device [m]: what is drawn now, where the handle ends whose hand goes
// this way, and some room; with a map all that the device reaches.
export function box_of(device, info, question, way) {
  const bounds = device.bounds();
  if (question.layers.includes('map')) return bounds;
  const drawing = device.drawing(),
    rows = drawing_rows(drawing.numbers, drawing.count),
    points = rows.flatMap(row => (is_line_row(row) ? [row.point, row.other] : [row.point])),
    handle = handle_of(rows);
  if (handle) points.push(way.map((w, i) => handle[i] + w));
  const room =
    view_share[info.dimension === 3 ? 'space' : question.is_moving ? 'moving' : 'still'] *
    Math.max(bounds[3] - bounds[0], bounds[4] - bounds[1]);
  return [0, 1, 2]
    .map(i => Math.min(...points.map(p => p[i])) - room)
    .concat([0, 1, 2].map(i => Math.max(...points.map(p => p[i])) + room));
}

// Margins of the picture of a device that leave room for what the brakes can make at the present place, and
// for F_d [pixels].
export function margins_of({device, info, scales, bounds, width, height, layers, is_moving}) {
  const least = width < 520 ? 18 : 34,
    margins = {left: least, right: least, top: least, bottom: least + (layers.has('map') ? 34 : 8)},
    x = device.value('x');
  if (info.dimension === 3 || is_moving || !layers.has('cone')) return margins;
  const force_scale = scales.force * Math.min(width, height),
    forces = cones_of({device, info, layers}).flatMap(cone => cone.points);
  if (layers.has('Fd')) {
    const Fd = device.value('Fd');
    forces.push(Fd.map(c => c * Math.min(1, max_arrow / (scales.force * length_of_vector(Fd) || 1))));
  }
  for (let turn = 0; turn < 3; ++turn) {
    const camera = fitting_camera(bounds, false, width, height, margins),
      at = camera.point(x);
    const heads = forces.map(f => {
      const d = camera.vector(f);
      return [at[0] + force_scale * d[0], at[1] + force_scale * d[1]];
    });
    const over = side => heads.reduce((largest, head) => Math.max(largest, side(head)), 0);
    margins.left = Math.min(0.24 * width, margins.left + over(head => least - head[0]));
    margins.right = Math.min(0.24 * width, margins.right + over(head => head[0] - width + least));
    margins.top = Math.min(0.24 * height, margins.top + over(head => least - head[1]));
    margins.bottom = Math.min(0.24 * height, margins.bottom + over(head => head[1] - height + least));
  }
  return margins;
}

// view: {device, info, scales, bounds, width, height, yaw, pitch, is_moving, tracks, focus, colors, value,
// layers, pointer, lens_memory, map, shows_hand}.
export function make_picture(view) {
  const {device, info, value} = view,
    is_space = info.dimension === 3,
    small = view.width < 520,
    size = Math.min(view.width, view.height);
  const camera = fitting_camera(
    view.bounds,
    is_space,
    view.width,
    view.height,
    view.margins,
    view.yaw,
    view.pitch,
  );
  const drawing = device.drawing(),
    rows = drawing_rows(drawing.numbers, drawing.count);
  const force_scale = view.scales.force * size,
    motion_scale = view.scales.motion * size;
  const picture = {
    camera,
    is_hollow: view.is_hollow,
    rows,
    brakes: view.brakes,
    handle: handle_of(rows),
    cones: cones_of(view),
    references: references_of(view),
    arrows: arrows_of(view),
    force_scale,
    motion_scale,
    shown: view.layers,
    paths: [],
    others: [],
    bounds: view.bounds,
    map: view.layers.has('map') ? view.map : null,
    gamma: gamma_of(view),
    walls: walls_in(device, camera, view.width, view.height, is_space, view.bounds),
    pointer: view.is_moving ? view.pointer : null,
    shows_hand: view.shows_hand,
  };
  if (view.is_moving) add_paths(picture, view, camera);
  if (view.is_moving && !is_space && picture.handle) picture.lens = lens_of(picture, view, camera, small);
  return picture;
}

function walls_in(device, camera, width, height, is_space, box) {
  if (is_space) return device.walls(box.slice(0, 2), box.slice(3, 5));
  const low = camera.back([0, height]),
    high = camera.back([width, 0]);
  return device.walls(low, high);
}

function cones_of({device, info, layers}) {
  const cones = [];
  const present = device.value('region')[0];
  if (layers.has('others'))
    for (let region = 0; region < 1 << info.brakes; ++region)
      if (region !== present)
        cones.push({
          points: device.outline(region, true),
          is_present: false,
          alpha: 0.9 / (1 << info.brakes),
          name: info.brakes === 2 ? 'FME ' + (region + 1) : '',
        });
  if (layers.has('cone')) cones.push({points: device.outline(-1, true), is_present: true});
  return cones.filter(cone => cone.points.length > 1 && cone.points.every(f => f.every(Number.isFinite)));
}

function references_of({device, info, layers}) {
  if (!layers.has('references')) return [];
  const R = device.value('R'),
    limits = device.value('torque_limit'),
    references = [];
  for (let k = 0; k < info.brakes; ++k)
    for (const sign of [1, -1]) {
      const vector = [0, 1, 2].map(i => sign * limits[k] * R[3 * k + i]);
      if (vector.every(Number.isFinite))
        references.push({vector, label: 'R_{' + (k + 1) + (sign > 0 ? '+' : '−') + '}'});
    }
  return references;
}

function arrows_of({value, is_moving}) {
  const arrows = [
    ...(is_moving
      ? [{id: 'brake_force', layer: 'made', label: 'made', vector: value('brake_force')}]
      : displayed_arrows(value)),
    {id: 'Fd', layer: 'Fd', label: 'F_{d}', vector: value('Fd')},
    {id: 'Fr', layer: 'Fr', label: 'F_{r}', vector: value('Fr')},
    {id: 'v', layer: 'v', label: 'v', vector: value('v'), is_motion: true},
    {id: 'Fh', layer: 'Fh', label: 'F_{h}', vector: value(is_moving ? 'hand_force' : 'Fh')},
  ];
  return arrows.filter(arrow => arrow.vector.length === 3 && arrow.vector.every(Number.isFinite));
}

const length_of_vector = f => Math.hypot(...f);

// The displayed force, named F_c or αF_c if the torque limits leave all of it, and pale the force without a law.
function displayed_arrows(value) {
  const displayed = value('displayed'),
    without_law = value('displayed_without_law');
  const is_same = (a, b) => length_of_vector(a.map((c, i) => c - b[i])) <= 1e-9 * length_of_vector(b);
  const name = force =>
    is_same(force, value('Fc')) ? 'F_{c}' : is_same(force, value('Fc_scaled')) ? 'αF_{c}' : '';
  const arrow = {id: 'displayed', layer: 'made', label: name(displayed) || 'displayed', vector: displayed};
  return is_same(displayed, without_law)
    ? [arrow]
    : [{id: 'without_law', layer: 'made', label: name(without_law), vector: without_law}, arrow];
}

function gamma_of({value, is_moving}) {
  const [gamma] = value('gamma'),
    Fd = value('Fd'),
    Fc = value('Fc');
  if (is_moving || !Number.isFinite(gamma) || !(length_of_vector(Fd) > 0) || !(length_of_vector(Fc) > 0))
    return null;
  return {vectors: [Fd, Fc], text: 'γ = ' + short_number(degrees(gamma), 3) + '°'};
}

function add_paths(picture, view, camera) {
  const {tracks, layers} = view;
  tracks.histories.forEach((history, law) => {
    const points = [];
    each_point(history, trail_seconds, k =>
      points.push([history.x[3 * k], history.x[3 * k + 1], history.x[3 * k + 2]]),
    );
    if (layers.has('paths') && points.length > 1) picture.paths.push({points, color: view.colors[law]});
    const x = tracks.value(law, 'x');
    if (!x) return;
    if (law === view.focus) picture.focus = {point: x, color: view.colors[law]};
    else picture.others.push({point: x, color: view.colors[law]});
  });
}

function lens_of(picture, view, camera, small) {
  const memory = view.lens_memory,
    at = picture.handle,
    normal = view.device.value('normal');
  if (Math.hypot(...normal) > 0.5) memory.normal = normal;
  if (!memory.centre || Math.hypot(memory.centre[0] - at[0], memory.centre[1] - at[1]) * camera.scale > 60)
    memory.centre = at.slice(0, 2);
  // The lens follows at once along the wall, and slowly across it, so that the hand is what moves.
  const away = [at[0] - memory.centre[0], at[1] - memory.centre[1]],
    n = memory.normal || [0, 0],
    across = away[0] * n[0] + away[1] * n[1];
  for (let i = 0; i < 2; ++i) memory.centre[i] += away[i] - (1 - lens_rise) * across * n[i];
  const radius = small ? 46 : Math.min(96, 0.19 * view.height),
    where = [view.width - radius - (small ? 12 : 22), view.height - radius - 44];
  const scale = camera.scale * lens_times,
    [depth] = view.value('depth');
  if (!(depth * scale > -2 * radius)) return null; // far from any wall there is nothing to see
  const lens_camera = plane_camera(scale, [
    where[0] - scale * memory.centre[0],
    where[1] + scale * memory.centre[1],
  ]);
  const low = memory.centre.map(c => c - radius / scale),
    high = memory.centre.map(c => c + radius / scale);
  return {
    at: where,
    radius,
    times: lens_times,
    centre: [...memory.centre, 0],
    camera: lens_camera,
    walls: view.device.walls(low, high),
  };
}
