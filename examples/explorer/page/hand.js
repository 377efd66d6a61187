// What the visitor moves in the picture: the handle, the heads of the arrows, the view of space.

import {app, engine, form_value, is_moving, is_simulated, is_space, pen, runner, value} from './app.js';
import {short_number} from './format.js';
import {make_grips} from './grips.js';
import {keep_link} from './link.js';
import {by_id, refuse} from './messages.js';
import {begin_map} from './open.js';
import {circle_path, line_path} from './pen.js';
import {arrow_style, min_length} from './forces.js';
import {set_paused} from './transport.js';
import {dot, length_of, minus, plus, times, unit} from './vectors.js';

const grips = make_grips(by_id('handles'));
const arrows = ['v', 'Fh', 'Fd', 'normal'];
const stub = {normal: [0, 40], v: [0, 40], Fh: [32, -28], Fd: [-40, 0]}; // where a grip waits while its arrow is too short to be taken [pixels]

export function add_grips() {
  let from = null;
  grips.add({
    id: 'scene',
    className: 'scene',
    grabbed(pixel) {
      from = pixel;
      if (!is_space()) {
        take_hand();
        move_handle(app.picture.camera.back(pixel, app.picture.handle));
      }
    },
    moved(pixel) {
      if (!is_space()) return move_handle(app.picture.camera.back(pixel, app.picture.handle));
      turn_view(0.008 * (pixel[0] - from[0]), 0.008 * (pixel[1] - from[1]));
      from = pixel;
    },
    released: let_go,
    keyed([x, y]) {
      is_space() ? turn_view(-0.08 * x, -0.08 * y) : nudge_handle([x, y, 0]);
    },
  });
  grips.add({
    id: 'handle',
    grabbed: take_hand,
    moved: pixel => move_handle(app.picture.camera.back(pixel, app.picture.handle)),
    released: let_go,
    keyed: nudge_handle,
  });
  for (const id of arrows) grips.add({id, moved: pixel => turn_arrow(id, pixel), keyed: move => push_arrow(id, move)});
}

function turn_view(yaw, pitch) {
  app.yaw -= yaw;
  app.pitch = Math.min(1.5, Math.max(-0.2, app.pitch + pitch));
  app.is_dirty = true;
}

export function place_grips() {
  const {picture} = app,
    at = picture.handle && picture.camera.point(picture.handle);
  grips.place('handle', at);
  for (const id of ['handle', ...arrows]) grips.mark(id, id === app.question.drag);
  for (const id of arrows) {
    const arrow = picture.arrows.find(other => other.id === id);
    const is_free =
      at &&
      !is_moving() &&
      app.layers.has(id) &&
      (id !== 'Fd' || /wanted|direct/.test(app.question.id)) &&
      (id !== 'normal' || (app.question.id === 'mine' && !is_space()));
    if (!is_free) {
      grips.place(id, null);
      continue;
    }
    const is_long = arrow?.head && length_of(minus(arrow.head, at)) > min_length,
      place = is_long ? arrow.head : plus(at, stub[id]);
    if (!is_long) {
      const {color} = arrow_style(id, app.theme),
        style = {size: 15, math: true, weight: 600, color, halo: app.theme.paper};
      pen.path(line_path(at, place), {stroke: color, width: 1.2, dash: [2, 4], alpha: 0.8});
      pen.path(circle_path(place, 5), {fill: app.theme.paper, stroke: color, width: 2});
      pen.label(id === 'v' ? 'v' : `F_{${id[1]}}`, place[0] + 9, place[1] + 5, style);
    }
    grips.place(
      id,
      place.map((c, i) => Math.min((i ? pen.height : pen.width) - 12, Math.max(12, c))),
    );
  }
}

export function name_grips() {
  const axes = ['x', 'y', 'z'].slice(0, app.info.dimension),
    text = (vector, factor, unit) =>
      axes.map((axis, i) => `${axis} ${short_number(vector[i] * factor)}`).join(', ') + ' ' + unit;
  grips.name(
    'scene',
    is_space() ? 'View in space, turned by the arrow keys' : 'Picture of the device. The arrow keys move the handle',
  );
  grips.name('handle', 'Handle at ' + text(value('x'), 100, 'cm'));
  grips.name('v', 'Velocity, ' + text(value('v'), 1, 'm/s'));
  grips.name('Fh', 'Hand force, ' + text(app.device.value('Fh'), 1, 'N'));
  grips.name('Fd', 'Force that the wall requires, ' + text(app.device.value('Fd'), 1, 'N'));
  grips.name('normal', 'Normal of the wall, ' + form_value('map.normal'));
}

// The visitor takes the handle: the hand by itself lets go.
function take_hand() {
  by_id('hint').hidden = true;
  if (!is_simulated()) return;
  app.is_held = true;
  app.pointer = value('x');
  if (app.is_by_itself) {
    app.is_by_itself = false;
    runner.send({kind: 'settings', text: 'hand=pointer'});
    by_id('self').setAttribute('aria-pressed', 'false');
  }
  if (app.is_paused) set_paused(false);
}

export function let_go() {
  if (!is_simulated()) return;
  app.is_held = false;
  send_pointer();
}

function send_pointer() {
  runner.send({kind: 'pointer', point: app.pointer || value('x'), is_held: app.is_held});
}

function move_handle(point) {
  if (app.log) return;
  if (is_simulated()) {
    app.pointer = point;
    return send_pointer();
  }
  const v = app.device.value('v');
  app.device.reach(point);
  app.device.move(v);
  evaluate();
}

function nudge_handle(move) {
  const step = 0.008 * app.scales.reach;
  if (is_simulated() && !app.is_held) take_hand();
  const from = is_simulated() ? app.pointer : app.device.value('x');
  move_handle(plus(from, move, step));
}

function turn_arrow(id, pixel) {
  const {camera, handle} = app.picture,
    at = camera.point(handle),
    d = minus(pixel, at),
    scale = length_of(d) < 14 ? 0 : 1 / scale_of(id);
  set_arrow(id, plus(camera.back_vector(times(scale, d)), camera.towards, dot(vector_of(id), camera.towards)));
}

const scale_of = id => app.picture[{v: 'motion_scale', normal: 'normal_scale'}[id] || 'force_scale'];
const vector_of = id =>
  id === 'normal' ? [...form_value('map.normal').split(',').map(Number), 0] : app.device.value(id);

function push_arrow(id, move) {
  set_arrow(id, plus(vector_of(id), move, 8 / scale_of(id)));
}

function set_arrow(id, vector) {
  if (id === 'normal') return turn_wall(vector);
  if (id === 'v') app.device.move(vector);
  else {
    if (id === 'Fd') app.device.set('desired=given');
    app.device.state()[id].set(vector);
  }
  evaluate();
}

// Step 5: a wall through the handle, and the map of a hand that slides along it.
let map_timer = 0;
function turn_wall(vector) {
  if (!length_of(vector)) return;
  const [x, y] = unit(vector).map(c => Number(c.toFixed(4))),
    place = value('x')
      .slice(0, 2)
      .map(c => Number(c.toPrecision(5)));
  if (!app.device.set(`map.normal=${x},${y}\nmap.direction=${-y},${x}\nscene=plane:${place},${x},${y}`))
    return refuse(engine.error());
  clearTimeout(map_timer);
  map_timer = setTimeout(begin_map, 250);
  evaluate();
}

export function evaluate() {
  app.device.evaluate();
  app.is_dirty = true;
  app.is_moved = true;
  keep_link();
  if (!app.preset) return;
  app.preset = null; // it is no longer what the figure shows
  app.shown();
}
