// Running and stopping: the simulation, its hand, its record, and a log that is played.

import {app, engine, runner, runner_events, tracks} from './app.js';
import {device_file_of} from './device_file.js';
import {by_id, say, warn} from './messages.js';
import {make_player} from './player.js';
import {save_file} from './save.js';

runner_events.refused = ({reason}) => warn(reason);
runner_events.log = ({text}) => {
  const law = app.laws[app.focus],
    simulated = engine.device(app.device.settings() + '\nlaw=' + law),
    device = device_file_of(app.info.id, law, simulated.form());
  simulated.delete();
  if (device) save_file('explorer_log.device.toml', device, 'application/toml');
  save_file('explorer_log.csv', text, 'text/csv');
  const command = './examples/run replay explorer_log.csv';
  say('explorer_log.csv is a log of the library. ' + (device ? 'It replays with: ' + command : ''));
};

export function set_paused(is_on) {
  app.is_paused = is_on;
  by_id('pause').setAttribute('aria-pressed', String(is_on));
  by_id('pause').textContent = is_on ? 'Play' : 'Pause';
  if (!is_on && app.device) by_id('hint').hidden = true;
  if (!app.log) runner.send({kind: 'pause', is_on});
  else if (!is_on && app.log.is_ended) app.log.restart();
  app.is_dirty = true;
}

export function set_speed(factor) {
  app.speed = factor;
  runner.send({kind: 'speed', factor});
}

export function set_by_itself(is_on) {
  app.is_by_itself = is_on;
  by_id('self').setAttribute('aria-pressed', String(is_on));
  runner.send({kind: 'settings', text: 'hand=' + (is_on ? 'along' : 'pointer')});
}

export function restart() {
  app.lens_memory = {};
  app.log ? app.log.restart() : runner.again();
  if (app.is_paused) set_paused(false);
}

// Whether the hand by itself came to the end of its way, under all laws, or well beyond under one.
export function is_way_done() {
  const shares = app.laws.map((_, law) => tracks().value(law, 'progress')?.[0] ?? 0);
  return Math.min(...shares) >= 1 || Math.max(...shares) >= 1.05;
}

export function toggle_record(button) {
  const is_on = button.getAttribute('aria-pressed') !== 'true';
  button.setAttribute('aria-pressed', String(is_on));
  button.textContent = is_on ? 'Stop recording' : 'Record';
  app.is_recording = is_on;
  if (is_on && app.is_paused) set_paused(false);
  runner.record(is_on);
  if (!is_on) by_id('download').disabled = false;
}

// Plays a log of the library through the law that is chosen.
export function open_log(text, name) {
  const log = engine.open_log(app.device.settings() + '\nlaw=' + (app.laws[app.focus] || app.law), text);
  if (!log) return say(name + ': ' + engine.error());
  const [equal, all] = log.agreement(),
    law = app.laws[app.focus] || app.law;
  app.log = make_player(log.layout, log.rows(), law);
  log.delete();
  app.laws = [law];
  app.focus = 0;
  runner.send({kind: 'pause', is_on: true});
  const agreement = all ? `; ${equal} of ${all} capacities are those of ${law} to the last digit.` : '.';
  say(`${name}: ${app.log.count} lines${agreement}`);
  set_paused(false);
  app.shown();
}

let last_played = 0;

export function play_log(now) {
  const passed = Math.min(0.1, (now - last_played) / 1000);
  last_played = now;
  app.log.advance(passed * app.speed);
  if (app.log.is_ended) set_paused(true);
}
