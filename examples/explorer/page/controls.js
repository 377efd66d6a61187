// The controls beside the picture: they show the state of the page, and change it.

import {app, engine, form_value, is_moving, runner} from './app.js';
import {make_form} from './form.js';
import {ended, set_sentence, symbol_html} from './format.js';
import {keep_link} from './link.js';
import {by_id, refuse} from './messages.js';
import {begin} from './open.js';
import {law_look, layers} from './story.js';

const groups = [
  ['mechanism', 'Mechanism'],
  ['brakes', 'Brakes'],
  ['map', 'Task of the design map'],
  ['law', 'Law'],
  ['options', 'Approximation'],
  ['scene', 'Wall'],
  ['hand', 'Hand'],
];
const form = make_form(by_id('form'), change_setting);

export function show_controls() {
  const {question} = app;
  set_sentence(by_id('lead'), app.preset ? ended(app.preset.title) + ' ' + app.preset.look : question.lead);
  const steps = by_id('questions').children;
  for (const link of steps) mark_current(link, Number(link.dataset.step) === question.step);
  for (const link of by_id('parts').children) mark_current(link, link.dataset.part === (question.part ?? ''));
  by_id('parts').hidden = question.step !== 4;
  const next = steps[question.step];
  by_id('next').hidden = !next;
  if (next) Object.assign(by_id('next'), {href: next.href, textContent: 'Next: ' + next.title});
  for (const link of by_id('presets').querySelectorAll('a')) mark_current(link, app.preset?.id === link.dataset.id);
  by_id('mechanism').value = app.info.id;
  by_id('law').value = app.law;
  show_scene();
  const beside = question.step === 4 && !!question.is_moving;
  for (const id of ['alpha_choice', 'alpha_law']) by_id(id).hidden = question.id !== 'direct';
  by_id('law_choice').hidden = beside;
  by_id('law_text').hidden = beside;
  by_id('law').title = app.law;
  by_id('law_text').textContent = law_look(app.law);
  for (const id of ['transport', 'plots', 'records']) by_id(id).hidden = !is_moving();
  document.body.dataset.question = question.id;
  document.body.classList.toggle('moving', is_moving());
  by_id('self').setAttribute('aria-pressed', String(app.is_by_itself));
  by_id('hint').hidden =
    !(question.is_moving && (question.step === 4 || !app.is_by_itself || app.is_paused)) || !!app.log;
  by_id('hint').textContent = app.is_paused
    ? 'Press Play: it moves only if you want it to'
    : innerWidth < 520
      ? 'Take the handle and drag it'
      : 'Take the handle: drag it, or press Tab and the arrow keys';
  show_form();
  show_legend();
}

function mark_current(link, is_current) {
  is_current ? link.setAttribute('aria-current', 'page') : link.removeAttribute('aria-current');
}

const show_form = () => form.show(app.device.form(), groups);

function show_scene() {
  const fitting = scenes.filter(([, , only]) => !only || only === app.info.dimension);
  by_id('scene').innerHTML = fitting.map(([id, label]) => `<option value="${id}">${label}</option>`).join('');
  by_id('scene').value = form_value('scene').split(':')[0];
}

// Kinds of walls, with the dimension that some need.
const scenes = [
  ['none', 'No wall'],
  ['plane', 'Plane'],
  ['solid', 'Circle or ball from outside'],
  ['hollow', 'Circle or ball from inside'],
  ['outline', 'Outline of a body', 2],
];

// A wall of this kind a little beyond the handle.
export function scene_text(kind) {
  const {reach} = app.scales,
    [x, y, ...z] = app.device.value('x').slice(0, app.info.dimension),
    at = (aside, ahead) => [x + aside * reach, y + ahead * reach, ...z];
  const numbers = {
    plane: [...at(0, 0.02), 0, -1, ...z.map(() => 0)],
    solid: [...at(0, 0.27), 0.25 * reach],
    hollow: [...at(0, -0.28), 0.3 * reach],
    outline: [at(-0.2, 0.04), at(0, 0.02), at(0.2, 0.04), at(0.12, 0.22), at(-0.12, 0.22)].flat(),
  }[kind];
  return numbers ? kind + ':' + numbers.map(c => Number(c.toPrecision(4))) : kind;
}

function show_legend() {
  by_id('legend').innerHTML = layers
    .filter(({id}) => app.layers.has(id))
    .map(layer => `<span>${legend_mark(layer)}${symbol_html(layer.label)}</span>`)
    .join('');
}

function legend_mark({mark, color}) {
  const shape = {
    area: `<path d="M2 10 13 1 24 8Z" fill="var(--${color})" fill-opacity=".35" stroke="var(--${color})"/>`,
    line: `<path d="M1 6H18" stroke="var(--${color})" stroke-width="2.4" fill="none"/><path d="M25 6 16 1.5 18 6 16 10.5Z" fill="var(--${color})"/>`,
    curve: `<path d="M1 10C8 2 16 2 25 5" stroke="var(--${color})" stroke-width="3" fill="none"/>`,
  }[mark];
  return `<svg aria-hidden="true" viewBox="0 0 26 12">${shape}</svg>`;
}

export function change_setting(name, text) {
  const line = name + '=' + text;
  if (!app.device.set(line)) {
    refuse(engine.error());
    show_form();
    return;
  }
  refuse('');
  app.is_own = true;
  const settings = app.device.settings();
  if (app.question.is_moving && !name.startsWith('mechanism.')) {
    runner.send({kind: 'settings', text: line});
    app.device.evaluate();
    show_controls();
    app.is_dirty = true;
  } else refuse(begin(app.question, settings, null, true));
  keep_link();
}
