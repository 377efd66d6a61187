// The loop that draws: the picture and the curves in each frame, sentences and numbers a few times a
// second.

import {
  app,
  brake_states,
  colors,
  follow_tracks,
  form_value,
  is_moving,
  is_simulated,
  is_space,
  pen,
  runner,
  tracks,
  value,
  word,
} from './app.js';
import {draw_curves} from './curves.js';
import {set_sentence, short_number} from './format.js';
import {name_grips, place_grips} from './hand.js';
import {by_id} from './messages.js';
import {make_numbers} from './numbers.js';
import {canvas_pen, svg_pen} from './pen.js';
import {make_picture, margins_of} from './picture.js';
import {draw_stage} from './stage.js';
import {design_sentence, laws_sentence, moment_sentence, still_sentence} from './story.js';
import {is_way_done, play_log} from './transport.js';

const curves_pen = canvas_pen(by_id('curves')),
  show_numbers = make_numbers(by_id('numbers'));
let last_slow = 0,
  is_even = false; // the curves are drawn in every other frame

function view_of(width, height) {
  const brakes = brake_states();
  if (width < 520) for (const brake of brakes) brake.text = brake.state; // there is no room for more
  const view = {
    ...app,
    normal: app.question.id === 'mine' && !is_space() ? [...form_value('map.normal').split(',').map(Number), 0] : null,
    bounds: app.box,
    width,
    height,
    is_moving: is_moving() && !!tracks(),
    tracks: tracks(),
    colors: is_moving() ? colors() : [],
    value,
    brakes,
    pointer: app.is_held ? app.pointer : null,
    shows_hand: is_simulated() && !app.is_held && app.is_by_itself,
  };
  const key = [width, height, app.begun].join();
  if (app.margins_key !== key) Object.assign(app, {margins_key: key, margins: margins_of(view)});
  return {...view, margins: app.margins};
}

function draw() {
  if (is_moving()) follow_tracks();
  pen.begin();
  if (!pen.width) return;
  const view = view_of(pen.width, pen.height);
  app.picture = make_picture(view);
  draw_stage(pen, app.picture, app.theme);
  place_grips();
  if (tracks() && (is_even = !is_even || app.is_paused)) {
    curves_pen.begin();
    draw_curves(curves_pen, tracks(), app.theme, colors());
  }
}

export function frame(now) {
  requestAnimationFrame(frame);
  const is_running = !app.is_paused && tracks();
  if (app.log && is_running) play_log(now);
  if (is_running && is_simulated() && app.is_by_itself && !app.is_recording && is_way_done()) {
    app.lens_memory = {};
    runner.again();
  }
  if (!app.is_dirty && !is_running) return;
  const is_slow_turn = app.is_dirty || now - last_slow > 200;
  app.is_dirty = false;
  draw();
  if (is_slow_turn) {
    last_slow = now;
    show_texts();
  }
}

// Sentences and numbers, a few times a second.
function show_texts() {
  set_sentence(by_id('answer'), sentence());
  if (tracks())
    show_numbers(tracks().layout, entry => tracks().value(app.focus, entry.id) || Array(entry.size).fill(NaN));
  else show_numbers(app.device.layout, entry => app.device.value(entry.id));
  show_alpha();
  name_grips();
}

function sentence() {
  const brakes = brake_states();
  if (tracks()?.laws.length > 1) return laws_sentence(tracks(), runner.last);
  if (tracks()) return moment_sentence(tracks(), app.focus, brakes, is_pushing());
  if (app.question.id === 'mine') return map_sentence();
  const made = app.picture?.made || [0, 0, 0],
    max_angle = Number(form_value('options.max_approximation_angle'));
  return still_sentence(app.question.id, {value, word, brakes, made, max_angle});
}

// The slider of step 4 stands at the present alpha.
function show_alpha() {
  if (app.question.id !== 'direct') return;
  const [alpha] = value('alpha');
  by_id('alpha').value = alpha;
  by_id('alpha').setAttribute('aria-valuetext', 'α = ' + short_number(alpha, 3));
}

// The hand pushes into the wall.
function is_pushing() {
  const force = tracks().value(app.focus, 'muscle_force'),
    normal = app.lens_memory.normal;
  return !normal || !force || !(force[0] * normal[0] + force[1] * normal[1] >= 0);
}

function map_sentence() {
  const words = app.device.layout.find(entry => entry.id === 'display').words;
  return app.map ? design_sentence(app.map, words) : '';
}

// The picture for slides, as an SVG document, or on a canvas with four pixels for one.
export function picture_svg() {
  return draw_on(svg_pen(pen.width, pen.height, app.theme.paper)).text();
}
export function picture_canvas() {
  const canvas = document.createElement('canvas'),
    drawing = canvas_pen(canvas);
  drawing.begin(pen.width, pen.height, 2);
  drawing.path(`M0 0H${pen.width}V${pen.height}H0Z`, {fill: app.theme.paper});
  draw_on(drawing);
  return canvas;
}

function draw_on(other_pen) {
  draw_stage(other_pen, make_picture(view_of(pen.width, pen.height)), app.theme);
  return other_pen;
}
