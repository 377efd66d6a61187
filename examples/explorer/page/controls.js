// The controls beside the picture: they show the state of the page, and change it.

import {app, engine, form_value, is_moving, runner} from './app.js';
import {make_form} from './form.js';
import {element, ended, set_sentence} from './format.js';
import {keep_link} from './link.js';
import {by_id, refuse} from './messages.js';
import {begin, start_runner} from './open.js';
import {layers} from './story.js';

const device_groups = [
    ['mechanism', 'Mechanism'],
    ['brakes', 'Brakes'],
  ],
  map_group = ['map', 'Task of the design map'];
const other_groups = [
  ['law', 'Law'],
  ['options', 'Approximation'],
  ['scene', 'Wall'],
  ['hand', 'Hand'],
];
const form = make_form(by_id('form'), change_setting);

export function show_controls() {
  const {question} = app;
  set_sentence(by_id('lead'), app.preset ? ended(app.preset.title) + ' ' + app.preset.look : question.lead);
  for (const link of by_id('questions').children) mark_current(link, link.dataset.id === question.id);
  show_current(by_id('questions'));
  for (const link of by_id('presets').querySelectorAll('a'))
    mark_current(link, app.preset?.id === link.dataset.id);
  by_id('mechanism').value = app.info.id;
  by_id('law').value = app.law;
  show_scene();
  const beside = question.id === 'watch' || question.id === 'laws';
  by_id('laws').hidden = !beside;
  by_id('law_choice').hidden = beside;
  by_id('law_text').hidden = beside;
  const law = engine.catalogue.laws.find(other => other.id === app.law);
  by_id('law_text').textContent = law
    ? law.look + (law.equation ? ' Equation (' + law.equation + ').' : '')
    : '';
  show_laws();
  for (const id of ['transport', 'plots']) by_id(id).hidden = !is_moving();
  document.body.dataset.question = question.id;
  document.body.classList.toggle('moving', is_moving());
  by_id('results').hidden = app.laws.length < 2 || !question.is_moving;
  by_id('map_choice').hidden = question.id !== 'mine';
  by_id('flip').hidden = question.is_moving || !app.info.has_branches;
  by_id('form_details').open = by_id('form_details').open || !!question.opens_form;
  by_id('self').setAttribute('aria-pressed', String(app.is_by_itself));
  by_id('hint').hidden = !(question.is_moving && (question.id === 'watch' || !app.is_by_itself)) || !!app.log;
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

// Brings the current link of a row into view where the row is wider than the screen.
function show_current(row) {
  const link = row.querySelector('[aria-current="page"]');
  if (link && row.scrollWidth > row.clientWidth)
    row.scrollLeft = link.offsetLeft - row.offsetLeft - (row.clientWidth - link.offsetWidth) / 2;
}

function show_form() {
  form.show(
    app.device.form(),
    app.question.id === 'mine'
      ? [...device_groups, map_group, ...other_groups]
      : [...device_groups, ...other_groups, map_group],
  );
}

function show_scene() {
  const text = form_value('scene'),
    select = by_id('scene'),
    kind = text.split(':')[0];
  const fitting = engine.catalogue.scenes.filter(scene => scene.dimensions.includes(app.info.dimension));
  select.replaceChildren(...fitting.map(scene => element('option', {value: scene.id, text: scene.label})));
  select.value = kind || 'none';
}

// A wall of this kind a little beyond the handle.
export function scene_text(kind) {
  if (kind === 'none') return kind;
  const x = app.device.value('x').slice(0, app.info.dimension),
    reach = app.scales.reach,
    y = x.map((c, i) => c + (i === 1 ? 0.02 * reach : 0));
  const along = (i, way) => y.map((c, k) => c + (k === i ? way : 0)),
    up = x.map((_, i) => (i === 1 ? -1 : 0));
  const numbers = {
    plane: () => [...y, ...up],
    solid: () => [...along(1, 0.25 * reach), 0.25 * reach],
    hollow: () => [...along(1, -0.3 * reach), 0.3 * reach],
    edge: () => [...y, -0.6, -0.8, 0.6, -0.8],
    outline: () =>
      [
        [-0.2, 0.02],
        [0, 0],
        [0.2, 0.02],
        [0.12, 0.2],
        [-0.12, 0.2],
      ].flatMap(([a, b]) => [y[0] + a * reach, y[1] + b * reach]),
    box: () => [
      ...x.map((c, i) => c - (i === 1 ? -0.02 : 0.15) * reach),
      ...x.map((c, i) => c + (i === 1 ? 0.2 : 0.15) * reach),
    ],
  }[kind]();
  return kind + ':' + numbers.map(c => Number(c.toPrecision(4))).join();
}

function show_laws() {
  by_id('law_list').replaceChildren(
    ...engine.catalogue.laws.map(law => {
      const at = app.laws.indexOf(law.id);
      const box = element('input', {
        type: 'checkbox',
        value: law.id,
        checked: at >= 0,
        onchange: () => toggle_law(law.id),
      });
      box.checked = at >= 0;
      return element(
        'label',
        {title: law.look},
        box,
        element('span', {
          class: 'swatch',
          style: at >= 0 && app.slots ? 'background:var(--law-' + (app.slots[at] + 1) + ')' : '',
        }),
        law.id,
      );
    }),
  );
}

function toggle_law(law) {
  if (app.laws.includes(law)) {
    if (app.laws.length > 1) app.laws = app.laws.filter(other => other !== law);
  } else app.laws = [...app.laws, law].slice(-3);
  start_runner();
  show_laws();
  by_id('law_list').querySelector(`input[value="${law}"]`)?.focus();
}

function show_legend() {
  const moving_only = ['paths'],
    is_used = id =>
      (id !== 'map' || app.question.id === 'mine') && (!moving_only.includes(id) || app.question.is_moving);
  by_id('legend').replaceChildren(
    ...layers
      .filter(layer => is_used(layer.id))
      .map(layer => {
        const button = element('button', {
          type: 'button',
          'aria-pressed': String(app.layers.has(layer.id)),
          'data-layer': layer.id,
        });
        button.innerHTML = legend_mark(layer.style);
        button.append(
          element(
            'span',
            {},
            ...layer.label
              .split(/(_\{[^}]*\})/)
              .map(part => (part.startsWith('_{') ? element('sub', {text: part.slice(2, -1)}) : part)),
          ),
        );
        button.addEventListener('click', () => {
          app.layers.has(layer.id) ? app.layers.delete(layer.id) : app.layers.add(layer.id);
          button.setAttribute('aria-pressed', String(app.layers.has(layer.id)));
          app.is_dirty = true;
        });
        return button;
      }),
  );
}

function legend_mark(style) {
  const line = (name, width, dash) =>
    `<svg aria-hidden="true" viewBox="0 0 26 12"><path d="M1 6H18" stroke="var(--${name})" stroke-width="${width}"${dash ? ` stroke-dasharray="${dash}"` : ''} fill="none"/><path d="M25 6 16 1.5 18 6 16 10.5Z" fill="var(--${name})"/></svg>`;
  const area = name =>
    `<svg aria-hidden="true" viewBox="0 0 26 12"><path d="M2 10 13 1 24 8Z" fill="var(--${name})" fill-opacity=".35" stroke="var(--${name})"/></svg>`;
  return (
    {
      cone: area('cone'),
      others: area('faint'),
      references: line('muted', 1.4, '4 3'),
      Fd: line('wanted', 2),
      Fc_scaled: line('made', 4),
      v: line('motion', 3),
      Fh: line('hand', 3),
      Fr: line('result', 2, '5 2'),
    }[style] || ''
  );
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
