// Beginning: what a link, a question or a figure of the paper starts with.

import {app, engine, form_value, runner} from './app.js';
import {make_design_map} from './design.js';
import {settings_of_file} from './device_file.js';
import {keep_link} from './link.js';
import {refuse, say, warn} from './messages.js';
import {box_of, scales_of} from './picture.js';
import {format_settings, parse_link, parse_settings, quoted} from './settings.js';
import {question_of, questions} from './story.js';
import {set_paused, set_speed} from './transport.js';
import {length_of, plus, times, unit} from './vectors.js';

const design = make_design_map(() => {
  paint_map();
  app.is_dirty = true;
});
const preset_of = id => engine.catalogue.presets.find(preset => preset.id === id);
const preset_laws = law => (law === 'no_direct_control' ? [law] : ['no_direct_control', law]);

// Opens what a link names; without one, step 1. A link that cannot be opened leaves what is
// shown, and the page states the reason.
export function open_link() {
  const is_place = location.hash === '#stage'; // of "Skip to the device"
  if (is_place && app.device) return;
  const reason = open_page(parse_link(is_place ? '' : location.hash));
  if (reason && !app.device) turn_to(questions[0]);
  warn(reason && 'This link cannot be opened: ' + reason);
}

// Returns why it cannot be opened, or nothing.
function open_page({page, settings, reason}) {
  if (reason) return reason;
  const name = settings ? (settings.get('page') ?? questions[0].id) : (page ?? questions[0].id),
    question = questions.find(other => other.id === name);
  if (settings && question) {
    settings.delete('page');
    return begin(question, format_settings(settings), null, true);
  }
  if (question) return turn_to(question);
  const preset = !settings && preset_of(name);
  if (preset) return begin(question_of(parse_settings(preset.settings), preset.id), preset.settings, preset, false);
  const expected = questions.map(other => other.id).join(', ');
  return `page = ${quoted(name)}: expected ` + (settings ? expected : expected + ' or the id of a figure');
}

// Goes to a question, with the device that was chosen, or with that of the question. Returns why not, as
// begin().
function turn_to(question) {
  if (app.is_own && app.device) return begin_own(question, app.device.settings());
  const settings = parse_settings(question.start || preset_of(question.preset).settings);
  if (!question.is_moving) settings.set('hand', 'pointer');
  return begin(question, format_settings(settings), null, false);
}

// Shows a device of the visitor's own. Returns why not, as begin().
export function begin_own(question, lines) {
  const settings = parse_settings(lines);
  settings.set('desired', is_given(question) ? 'given' : 'scene');
  settings.set('alpha', question.id === 'direct' ? '1' : '-1');
  settings.set('hand', question.is_moving ? 'along' : 'pointer');
  return begin(question, format_settings(settings), null, true);
}

// Opens a device file, and says what of it is not shown.
export function open_device_file(text, name) {
  let file;
  try {
    file = settings_of_file(text);
  } catch (reason) {
    return say(`${name}, ${reason}`);
  }
  const reason = begin_own(app.question, file.text);
  if (reason) return say(`${name}: ${reason}`);
  say(`${name} is open.` + (file.left_out.size ? ` Not shown: ${[...file.left_out].join(', ')}.` : ''));
  keep_link();
}

// Returns why these settings are refused, with nothing changed, or nothing.
export function begin(question, settings, preset, is_own) {
  const device = engine.device(settings);
  if (!device) return engine.error();
  refuse('');
  warn('');
  const is_new_question = question !== app.question || !app.device;
  app.device?.delete();
  Object.assign(app, {
    device,
    question,
    preset,
    is_own,
    is_moved: false,
    log: null,
    pointer: null,
    is_held: false,
    lens_memory: {},
  });
  const lines = parse_settings(device.settings()),
    mechanism = lines.get('mechanism') || engine.catalogue.mechanisms[0].id;
  app.info = engine.catalogue.mechanisms.find(other => other.id === mechanism);
  app.law = lines.get('law') || form_value('law');
  if (is_new_question || preset) app.layers = new Set(question.layers);
  if (app.info.dimension === 3) app.layers.delete('others');
  if (question.id === 'wanted' && lines.has('Fh')) for (const layer of ['Fh', 'Fr']) app.layers.add(layer);
  if (preset) app.laws = question.is_moving ? preset_laws(app.law) : [];
  else if (is_new_question) app.laws = [...(question.laws || [])];
  app.is_by_itself = question.is_moving && form_value('hand') === 'along';
  if (question.is_moving && app.laws.length === 1) app.law = app.laws[0];
  device.evaluate();
  app.bounds = device.bounds();
  app.box = box_of(device, app.info, question, way_of_hand());
  app.scales = scales_of(device, app.info);
  if (!preset && (question.id === 'forces' || is_given(question))) start_still(question);
  app.begun = (app.begun || 0) + 1;
  app.is_hollow = form_value('scene').startsWith('hollow');
  app.map = null;
  design.end();
  if (question.is_moving) {
    if (is_new_question) set_speed(question.speed || 1);
    set_paused(matchMedia('(prefers-reduced-motion: reduce)').matches);
    start_runner();
  } else runner.send({kind: 'pause', is_on: true});
  if (question.id === 'mine') begin_map();
  app.shown();
  app.is_dirty = true;
}

// How far a hand by itself goes [m].
function way_of_hand() {
  if (!app.is_by_itself) return [0, 0, 0];
  const direction = form_value('hand.path.direction').split(',').map(Number),
    length = Number(form_value('hand.path.length'));
  return times(length, unit([...direction, 0].slice(0, 3)));
}

// A motion and forces to begin with where a still picture has none: the handle goes aside, the wanted force is that
// of a wall in front, and the hand pushes against it.
function start_still(question) {
  const {device, info} = app,
    state = device.state(),
    has = id => length_of(device.value(id)) > 0;
  if (!has('v')) device.move([0.1 * app.scales.reach, 0, 0]);
  device.evaluate();
  app.scales = scales_of(device, info); // the cone of a device with more joints than needed depends on its motion
  if (!is_given(question) || device.word('status') !== 'ok') return;
  const out = info.dimension === 3 ? [0, 0, 1] : [0, -1, 0],
    size = 0.2 / app.scales.force;
  if (!has('Fd')) {
    if (question.id === 'wanted') device.set('law=' + (app.law = 'no_direct_control'));
    state.Fd.set(times(size, out));
    device.set('desired=given');
  }
  if (question.id === 'direct' && !has('Fh')) {
    state.Fh.set(plus([0.3 * size, 0, 0], out, -0.5 * size));
    device.move(plus(device.value('v'), out, 0.02 * app.scales.reach));
  }
  device.evaluate();
}

const is_given = question => question.id === 'wanted' || question.id === 'direct';

// alpha of equation (12) at the present pose, whatever alpha is set.
export function alpha_of_law(device) {
  const lines = parse_settings(device.settings());
  device.set('alpha=-1\nlaw=direct_control');
  device.evaluate();
  const [alpha] = device.value('alpha');
  device.set('alpha=' + (lines.get('alpha') ?? -1) + '\nlaw=' + lines.get('law'));
  device.evaluate();
  return alpha;
}

const ahead = 2400; // cycles that a page shows whose visitor wants no motion [1]

export function start_runner() {
  const text = app.device.settings(),
    x = app.device.value('x');
  warn('');
  app.focus = Math.max(0, app.laws.length - 1);
  runner.start(
    app.laws.map(law => text + '\nlaw=' + law),
    app.laws,
    x,
    app.is_paused ? ahead : 0,
  );
}

export function begin_map() {
  if (!design.begin(app.device, app.bounds)) refuse(engine.error());
  paint_map();
}

function paint_map() {
  app.map = app.question.id === 'mine' && design.picture();
}
