// The page: its lists are filled, its controls are wired, and what the link names is opened.

import {app, engine, is_moving, is_simulated, runner} from './app.js';
import {change_setting, scene_text, show_controls} from './controls.js';
import {add_grips, evaluate, let_go} from './hand.js';
import {keep_link} from './link.js';
import {by_id, refuse} from './messages.js';
import {alpha_of_law, begin_own, open_device_file, open_link, start_runner} from './open.js';
import {save_file, watch_files} from './save.js';
import {page_address, page_link} from './settings.js';
import {frame, picture_canvas, picture_svg} from './show.js';
import {law_name, parts, questions} from './story.js';
import {read_theme, watch_theme} from './theme.js';
import {open_log, restart, set_by_itself, set_paused, toggle_record} from './transport.js';

const is_figure = preset => /^fig/.test(preset.id);

const on = (id, type, run) => by_id(id).addEventListener(type, run);
const redraw = () => {
  app.is_dirty = true;
};

function fill_lists() {
  const {presets, mechanisms, laws} = engine.catalogue;
  const link = ({id, title, look}) => `<a href="${page_address(id)}" data-id="${id}" title="${look}">${title}</a>`,
    option = (value, text, title = '') => `<option value="${value}" title="${title}">${text}</option>`;
  by_id('questions').innerHTML = questions
    .filter(question => question.short)
    .map(
      ({id, step, title, short}) =>
        `<a href="${page_address(id)}" data-step="${step}" title="${title}"><b aria-hidden="true">${step}</b><span class="long">${title}</span><span class="short" aria-hidden="true">${short}</span></a>`,
    )
    .join('');
  by_id('parts').innerHTML = parts
    .map(({id, part, title}) => `<a href="${page_address(id)}" data-part="${part || ''}">${title}</a>`)
    .join('');
  by_id('figures').innerHTML = presets.filter(is_figure).map(link).join('');
  by_id('others').innerHTML = presets
    .filter(preset => !is_figure(preset))
    .map(link)
    .join('');
  by_id('mechanism').innerHTML = mechanisms.map(({id, label}) => option(id, label)).join('');
  by_id('law').innerHTML = laws.map(id => option(id, law_name(id), id)).join('');
}

function choose_mechanism({target}) {
  refuse(begin_own(app.question, 'mechanism=' + target.value));
  keep_link();
}

function choose_law({target}) {
  if (!app.device.set('law=' + target.value)) refuse(engine.error());
  else {
    refuse('');
    app.law = target.value;
    app.is_own = true;
    if (app.question.is_moving) {
      app.laws = [app.law];
      start_runner();
    }
    evaluate();
  }
  show_controls();
}

function set_alpha(alpha) {
  app.device.set('alpha=' + alpha);
  evaluate();
}

function wire() {
  on('mechanism', 'change', choose_mechanism);
  on('law', 'change', choose_law);
  on('scene', 'change', event => change_setting('scene', scene_text(event.target.value)));
  on('alpha', 'input', event => {
    const alpha = Number(event.target.value),
      best = alpha_of_law(app.device);
    set_alpha(Math.abs(alpha - best) < 0.013 ? best : alpha); // the slider catches at equation (12)
  });
  on('alpha_law', 'click', () => set_alpha(alpha_of_law(app.device)));
  on('more', 'toggle', () => {
    document.body.classList.toggle('with_more', by_id('more').open);
    redraw();
  });
  on('pause', 'click', () => set_paused(!app.is_paused));
  on('restart', 'click', restart);
  on('self', 'click', () => set_by_itself(!app.is_by_itself));
  on('record', 'click', event => toggle_record(event.target));
  on('download', 'click', () => runner.send({kind: 'log', law: app.focus}));
  on('save_svg', 'click', () => save_file('explorer.svg', picture_svg(), 'image/svg+xml'));
  on('save_png', 'click', () => picture_canvas().toBlob(image => save_file('explorer.png', image, 'image/png')));
  on('theme', 'click', () => set_theme(document.documentElement.dataset.theme === 'dark' ? 'light' : 'dark'));
  on('form', 'submit', event => event.preventDefault());
  watch_theme(() => {
    app.theme = read_theme();
    app.is_dirty = true;
  });
  watch_files(document.body, by_id('open_file'), (text, name) =>
    (/\.toml$/i.test(name) ? open_device_file : open_log)(text, name),
  );
  addEventListener('hashchange', () => {
    open_link();
    keep_link();
  });
  addEventListener('keydown', shortcut);
  new ResizeObserver(redraw).observe(by_id('stage'));
  document.addEventListener('visibilitychange', () =>
    runner.send({kind: 'pause', is_on: document.hidden || app.is_paused || !is_simulated()}),
  );
}

function set_theme(name) {
  document.documentElement.dataset.theme = name;
}

function shortcut(event) {
  if (event.ctrlKey || event.metaKey || event.altKey || /^(INPUT|SELECT|TEXTAREA)$/.test(event.target.tagName)) return;
  const question = questions.find(({step, short}) => short && step === Number(event.key));
  if (question) location.hash = page_link(question.id);
  else if (!is_moving()) return;
  else if (event.key === ' ' && event.target.tagName !== 'BUTTON' && event.target.tagName !== 'A') {
    event.preventDefault();
    set_paused(!app.is_paused);
  } else if (event.key === 'r') restart();
  else if (event.key === 'h') set_by_itself(!app.is_by_itself);
  else if (event.key === 'Escape') let_go();
}

if (!document.documentElement.dataset.theme && matchMedia('(prefers-color-scheme: dark)').matches) set_theme('dark');
app.theme = read_theme();
app.shown = show_controls;
fill_lists();
wire();
add_grips();
open_link();
requestAnimationFrame(frame);
document.documentElement.dataset.ready = 'true';
