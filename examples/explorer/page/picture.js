// The picture of the present state, as stage.js draws it: what the engine computed, with scales and a
// camera.

import {fitting_camera, plane_camera} from './camera.js';
import {max_arrow} from './forces.js';
import {degrees, short_number} from './format.js';
import {each_point} from './tracks.js';
import {drawing_rows, handle_of, is_line_row} from './sketch.js';
import {dot, length_of, minus, plus, times} from './vectors.js';

const cone_share = 0.34; // of the smaller side of the picture: the strongest force that the brakes make [1]
const view_share = {still: 0.07, moving: 0.075, space: 0.06}; // of the reach, around the device at its first place [1]
const motion_share = 0.13; // of the smaller side: the velocity at first [1]
const trail_seconds = 1.6; // of the paths of the hands
const locus_share = 0.13; // of the reach: the curve of a brake that holds, to each side [1]
const normal_length = 84; // of the normal of step 5 [pixels]
const sample_gap = 0.05; // between two directions of a sampled area; more is outside of it [rad]
const min_shown = 1e-3; // of the torque limit; a torque below is written as 0 [1]
const lens_times = 10; // enlargement of the lens
const lens_rise = 0.06; // how fast the lens follows [1 a picture]

// The scales of a device, which stay while it moves: pixels for a newton and for a metre a second, at a
// picture of size 1.
export function scales_of(device, info) {
  let strongest = 0;
  for (let region = 0; region < 1 << info.brakes; ++region)
    for (const force of device.outline(region))
      if (force.every(Number.isFinite)) strongest = Math.max(strongest, length_of(force));
  const bounds = device.bounds(),
    reach = Math.max(bounds[3] - bounds[0], bounds[4] - bounds[1], bounds[5] - bounds[2]);
  const speed = length_of(device.value('v'));
  // Where a brake alone makes no force (n > d): what all make together, or would at half of the reach.
  if (!strongest)
    for (const force of device.outline(-1))
      if (force.every(Number.isFinite)) strongest = Math.max(strongest, length_of(force));
  if (!strongest) strongest = (2 * device.value('torque_limit').reduce((sum, limit) => sum + limit, 0)) / reach;
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
  const rows = drawing_rows(device.drawing()),
    points = rows.flatMap(row => (is_line_row(row) ? [row.point, row.other] : [row.point])),
    handle = handle_of(rows);
  if (handle) points.push(plus(handle, way));
  const room =
    view_share[info.dimension === 3 ? 'space' : question.is_moving ? 'moving' : 'still'] *
    Math.max(bounds[3] - bounds[0], bounds[4] - bounds[1]);
  const edge = (find, way) => [0, 1, 2].map(i => find(...points.map(p => p[i])) + way * room);
  return [...edge(Math.min, -1), ...edge(Math.max, 1)];
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
    forces.push(times(Math.min(1, max_arrow / (scales.force * length_of(Fd) || 1)), Fd));
  }
  for (let turn = 0; turn < 3; ++turn) {
    const camera = fitting_camera(bounds, false, width, height, margins),
      at = camera.point(x),
      heads = forces.map(f => plus(at, camera.vector(f), force_scale));
    const widen = (side, most, over) => {
      margins[side] = Math.min(0.24 * most, margins[side] + Math.max(0, ...heads.map(head => over(head) + least)));
    };
    widen('left', width, head => -head[0]);
    widen('right', width, head => head[0] - width);
    widen('top', height, head => -head[1]);
    widen('bottom', height, head => head[1] - height);
  }
  return margins;
}

// view: {device, info, question, scales, bounds, margins, width, height, yaw, pitch, is_moving, tracks, focus, colors,
// value, word, layers, brakes, pointer, lens_memory, map, normal, shows_hand, is_hollow}.
export function make_picture(view) {
  const {device, info, layers} = view,
    is_space = info.dimension === 3,
    size = Math.min(view.width, view.height);
  const camera = fitting_camera(view.bounds, is_space, view.width, view.height, view.margins, view.yaw, view.pitch);
  const rows = drawing_rows(device.drawing()),
    made = made_force(view);
  const picture = {
    camera,
    rows,
    made,
    marked: view.question.drag,
    brakes: view.brakes,
    is_hollow: view.is_hollow,
    handle: handle_of(rows),
    cones: cones_of(view),
    references: references_of(view),
    arrows: arrows_of(view, made),
    force_scale: view.scales.force * size,
    motion_scale: view.scales.motion * size,
    normal_scale: normal_length,
    shown: layers,
    paths: [],
    others: [],
    bounds: view.bounds,
    map: layers.has('map') ? view.map : null,
    gamma: gamma_of(view, made),
    pointer: view.is_moving ? view.pointer : null,
    shows_hand: view.shows_hand,
  };
  picture.walls = walls_in(view, picture);
  if (layers.has('locus') && info.joints === 2 && !is_space) picture.locus = locus_of(view);
  if (view.is_moving) add_paths(picture, view);
  if (view.is_moving && !is_space && picture.handle) picture.lens = lens_of(picture, view, camera);
  return picture;
}

// What each brake does, with its torque in words. value, word: of the simulation or the device.
export function brakes_of(device, value, word) {
  const limits = device.value('torque_limit'),
    unit = device.layout.find(entry => entry.id === 'torque').unit,
    torques = value('brake_torque');
  return (torques.length ? torques : value('torque')).map((torque, k) => {
    const state = word('brake_state', k) || 'released',
      share = Math.abs(torque) / limits[k],
      text = short_number(share < min_shown ? 0 : Math.abs(torque), 2) + ' ' + unit;
    return {state, share, text: state === 'released' ? state : state + ', ' + text};
  });
}

// The force of the brakes within their limits, as the picture draws it and the sentences name it: in motion that of
// the simulated brakes, at rest that of the predicted torques, or of the commanded ones if no hand is there. It
// ends at the edge of the drawn area, which a simulated brake leaves for one cycle when its rotation reverses.
function made_force({device, info, value, is_moving}) {
  const simulated = value('brake_force'),
    predicted = device.value('brake_force'),
    commanded = device.value('displayed'),
    has_hand = length_of(device.value('Fh')) > 0 && info.joints === info.dimension,
    force = is_moving && simulated.every(Number.isFinite) ? simulated : is_moving || has_hand ? predicted : commanded;
  if (info.dimension === 3) return force;
  const share = share_inside(force, area_of(device, info));
  return share > 1 - 1e-6 ? force : times(share, force);
}

// The area of the present forces. That of a device with self-motion is sampled by direction: the force that its law
// displays is a corner of it.
function area_of(device, info) {
  const points = device.outline(-1),
    angle = f => Math.atan2(f[1], f[0]);
  if (info.joints === info.dimension || info.dimension === 3) return points;
  const corners = [...points, device.value('displayed')].filter(f => length_of(f) > 0);
  return corners
    .sort((a, b) => angle(a) - angle(b))
    .flatMap((f, k) => {
      const gap = angle(f) - angle(corners.at(k - 1)) + (k ? 0 : 2 * Math.PI);
      return gap > sample_gap ? [[0, 0, 0], f] : [f];
    });
}

// The share of a force that a polygon about 0 contains, at most 1.
function share_inside(force, polygon) {
  const turn = (a, b) => a[0] * b[1] - a[1] * b[0],
    size = length_of(force);
  let share = 0;
  polygon.forEach((a, k) => {
    const b = polygon[(k + 1) % polygon.length],
      edge = minus(b, a),
      across = turn(force, edge),
      along = turn(a, force) / across; // of the edge
    if (Math.abs(turn(force, a)) <= 1e-9 * size * length_of(a))
      // a corner in the direction of the force
      share = Math.max(share, dot(force, a) / size ** 2);
    else if (along > -1e-6 && along < 1 + 1e-6) share = Math.max(share, turn(a, edge) / across);
  });
  return Math.min(1, share || 0);
}

// The walls; behind a force that is given, the wall that would want it.
function walls_in({device, info, width, height, bounds, question, scales, value}, {camera, handle}) {
  if (info.dimension === 3) return device.walls(bounds.slice(0, 3), bounds.slice(3));
  const walls = device.walls(camera.back([0, height]), camera.back([width, 0])),
    Fd = value('Fd'),
    far = (10 * scales.reach) / length_of(Fd);
  if (walls.length || question.id !== 'wanted' || !handle || !Number.isFinite(far)) return walls;
  return [1, -1].map(side => [handle[0] + side * far * Fd[1], handle[1] - side * far * Fd[0], 0]);
}

// The curve on which the handle moves while the brake holds that is at rest now, or was last.
function locus_of({device, scales, brakes, lens_memory}) {
  const holding = brakes.flatMap((brake, k) => (brake.state === 'holds' && brake.share > 0 ? [k] : []));
  if (holding.length === 1) lens_memory.held = holding[0];
  if (holding.length > 1 || lens_memory.held === undefined) return null;
  return {points: device.locus(lens_memory.held, locus_share * scales.reach), is_held: holding.length === 1};
}

function cones_of({device, info, layers}) {
  const cones = [],
    present = device.value('region')[0],
    name = region => (info.brakes === 2 && info.joints === 2 && region >= 0 ? 'FME ' + (region + 1) : '');
  if (layers.has('others'))
    for (let region = 0; region < 1 << info.brakes; ++region)
      if (region !== present)
        cones.push({points: device.outline(region), alpha: 0.9 / (1 << info.brakes), name: name(region)});
  if (layers.has('cone'))
    cones.push({points: area_of(device, info), is_present: true, alpha: 0.3, name: name(present)});
  return cones.filter(cone => cone.points.length > 1 && cone.points.every(f => f.every(Number.isFinite)));
}

// R_i+ and R_i-; those of the present area with their size.
function references_of({device, info, layers}) {
  if (!layers.has('references')) return [];
  const [R, limits, signs] = ['R', 'torque_limit', 'signs'].map(id => device.value(id)),
    references = [];
  for (let k = 0; k < info.brakes; ++k)
    for (const sign of [1, -1]) {
      const vector = times(sign * limits[k], R.slice(3 * k, 3 * k + 3)),
        size = sign * signs[k] <= 0 ? ' ' + short_number(length_of(vector), 2) + ' N' : '';
      if (vector.every(Number.isFinite))
        references.push({vector, label: 'R_{' + (k + 1) + (sign > 0 ? '+' : '−') + '}' + size});
    }
  return references;
}

function arrows_of({value, is_moving, normal}, made) {
  const [Fc, scaled] = [value('Fc'), value('Fc_scaled')],
    is_same = (a, b) => length_of(minus(a, b)) <= 1e-9 * length_of(b);
  const arrows = [
    {id: 'Fd', layer: 'Fd', label: 'F_{d}', vector: value('Fd')},
    ...(length_of(Fc) > 1.001 * length_of(made) ? [{id: 'Fc', layer: 'made', label: 'F_{c}', vector: Fc}] : []),
    {
      id: 'made',
      layer: 'made',
      label: is_same(made, Fc) ? 'F_{c}' : is_same(made, scaled) ? 'αF_{c}' : 'brakes',
      vector: made,
    },
    {id: 'v', layer: 'v', label: 'v', vector: value('v'), scale: 'motion_scale'},
    {id: 'Fh', layer: 'Fh', label: 'F_{h}', vector: value(is_moving ? 'hand_force' : 'Fh')},
    {id: 'Fr', layer: 'Fr', label: 'F_{r}', vector: value('Fr')},
    {id: 'normal', layer: 'normal', label: 'n', vector: normal || [], scale: 'normal_scale'},
  ];
  return arrows.filter(arrow => arrow.vector.length === 3 && arrow.vector.every(Number.isFinite));
}

// The angle between F_d and the force of the brakes.
function gamma_of({value, is_moving}, made) {
  const Fd = value('Fd'),
    sizes = length_of(Fd) * length_of(made),
    [gamma] = value('gamma');
  if (is_moving || !(sizes > 0)) return null;
  const angle = Math.acos(Math.min(1, dot(made, Fd) / sizes)),
    is_gamma = Math.abs(angle - gamma) < 1e-4;
  return {
    vectors: [Fd, made],
    text: (is_gamma ? 'γ = ' : '') + short_number(degrees(is_gamma ? gamma : angle), 3) + '°',
  };
}

function add_paths(picture, view) {
  const {tracks, layers} = view;
  tracks.histories.forEach((history, law) => {
    const points = [];
    each_point(history, trail_seconds, k => points.push([...history.x.subarray(3 * k, 3 * k + 3)]));
    if (layers.has('paths') && points.length > 1) picture.paths.push({points, color: view.colors[law]});
    const x = tracks.value(law, 'x');
    if (!x) return;
    if (law === view.focus) picture.focus = {point: x, color: view.colors[law]};
    else picture.others.push({point: x, color: view.colors[law]});
  });
}

function lens_of(picture, view, camera) {
  const small = view.width < 520,
    memory = view.lens_memory,
    at = picture.handle,
    normal = view.device.value('normal');
  if (length_of(normal) > 0.5) memory.normal = normal;
  if (!memory.centre || length_of(minus(memory.centre, at)) * camera.scale > 60) memory.centre = at;
  // The lens follows at once along the wall, and slowly across it, so that the hand is what moves.
  const n = memory.normal || [0, 0, 0];
  memory.centre = plus(at, n, -(1 - lens_rise) * dot(minus(at, memory.centre), n));
  const radius = small ? 46 : Math.min(96, 0.19 * view.height),
    where = [view.width - radius - (small ? 12 : 22), view.height - radius - 44];
  const scale = camera.scale * lens_times,
    [depth] = view.value('depth');
  if (!(depth * scale > -2 * radius)) return null; // far from any wall there is nothing to see
  const {centre} = memory,
    half = [radius / scale, radius / scale, 0];
  return {
    at: where,
    radius,
    times: lens_times,
    centre,
    camera: plane_camera(scale, [where[0] - scale * centre[0], where[1] + scale * centre[1]]),
    walls: view.device.walls(minus(centre, half), plus(centre, half)),
  };
}
