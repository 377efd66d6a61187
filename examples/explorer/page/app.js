// The state of the page: the device, the question that is looked at, and the numbers that are shown.

import {bytes_of, load_engine} from './engine.js';
import {by_id} from './messages.js';
import {canvas_pen} from './pen.js';
import {brakes_of} from './picture.js';
import {make_runner} from './runner.js';
import {questions} from './story.js';
import {read_theme} from './theme.js';

const code = by_id('engine-code').textContent,
  bytes = await bytes_of(by_id('engine-wasm').textContent);
export const engine = await load_engine(code, bytes);

// question: the view; device: of the engine, with what the catalogue has of its mechanism in info; preset: of the catalogue, as
// long as nothing was changed; laws: of the simulation; focus: the one whose device is drawn; shown(): is
// called where the controls have to follow.
export const app = {
  question: questions[0],
  preset: null,
  device: null,
  info: null,
  law: '',
  laws: [],
  focus: 0,
  layers: new Set(),
  is_own: false,
  theme: read_theme(),
  yaw: 0.6,
  pitch: 0.5,
  pointer: null,
  is_held: false,
  is_paused: false,
  speed: 1,
  is_by_itself: true,
  is_dirty: true,
  map: null,
  log: null,
  lens_memory: {},
  shown() {},
};
export const pen = canvas_pen(by_id('picture'));
export const runner_events = {
  started() {
    app.is_dirty = true;
  },
  came() {
    app.is_dirty ||= app.is_paused;
  },
};
export const runner = make_runner(code, bytes, by_id('worker-code').textContent, runner_events);

// The rows that are shown: of the log that is played, or of the simulation.
export const tracks = () => (app.log ? app.log.tracks : app.question.is_moving ? runner.tracks : null);
export const is_simulated = () => app.question.is_moving && !app.log;
export const is_moving = () => !!app.log || !!app.question.is_moving;
export const is_space = () => app.info.dimension === 3;

const law_slots = {no_direct_control: 0, velocity_direct_control: 1}; // of the colours of laws, 2 for others
export const colors = () => app.laws.map(law => app.theme.laws[law_slots[law] ?? 2]);
export const form_value = name => app.device.form().find(entry => entry.name === name)?.value ?? '';

// The numbers of a value: of the last row, else of the device.
export const value = id => tracks()?.value(app.focus, id) ?? app.device.value(id);
export const word = (id, k) => tracks()?.word(app.focus, id, k) ?? app.device.word(id, k);
export const brake_states = () => brakes_of(app.device, value, word);

// The device takes the state of the last row.
export function follow_tracks() {
  const q = tracks()?.value(app.focus, 'q');
  if (!q) return;
  const state = app.device.state();
  state.q.set(q);
  state.qd.set(tracks().value(app.focus, 'qd'));
  state.Fh.set(tracks().value(app.focus, 'hand_force'));
  app.device.evaluate();
}
