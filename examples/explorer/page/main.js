// The page: its lists are filled, its controls are wired, and what the link names is opened.

import {app, engine, is_moving, is_simulated, pen, runner} from './app.js';
import {change_setting, scene_text, show_controls} from './controls.js';
import {element} from './format.js';
import {add_grips, evaluate, let_go} from './hand.js';
import {keep_link, own_link} from './link.js';
import {by_id, refuse, say} from './messages.js';
import {copy_text} from './numbers.js';
import {begin, open_link, paint_map, start_runner} from './open.js';
import {save_png, save_text, watch_files} from './save.js';
import {page_address, page_link} from './settings.js';
import {frame, picture_svg, sound} from './show.js';
import {questions} from './story.js';
import {read_theme, watch_theme} from './theme.js';
import {open_log, restart, set_by_itself, set_paused, set_speed, toggle_record} from './transport.js';

const is_figure = preset => /^fig/.test(preset.id);

function wire() {
  by_id('questions').append(
    ...questions.map(question =>
      element(
        'a',
        {href: page_address(question.id), 'data-id': question.id},
        element('b', {text: question.mark, 'aria-hidden': 'true'}),
        question.title,
      ),
    ),
  );
  for (const [id, is_here] of [
    ['figures', is_figure],
    ['others', preset => !is_figure(preset)],
  ])
    by_id(id).append(
      ...engine.catalogue.presets
        .filter(is_here)
        .map(preset =>
          element(
            'a',
            {href: page_address(preset.id), 'data-id': preset.id, title: preset.look},
            preset.title,
          ),
        ),
    );
  by_id('mechanism').append(
    ...engine.catalogue.mechanisms.map(mechanism =>
      element('option', {value: mechanism.id, text: mechanism.label}),
    ),
  );
  by_id('law').append(
    ...engine.catalogue.laws.map(law => element('option', {value: law.id, text: law.id})),
  );
  by_id('map_figure').append(
    ...engine.catalogue.figures.map((figure, k) => element('option', {value: k, text: figure.label})),
  );
  by_id('mechanism').addEventListener('change', event => {
    const settings =
      'mechanism=' +
      event.target.value +
      '\nhand=' +
      (app.question.is_moving ? 'along' : 'pointer') +
      '\ndesired=' +
      (app.question.id === 'wanted' ? 'given' : 'scene');
    refuse(begin(app.question, settings, null, true));
    keep_link();
  });
  by_id('law').addEventListener('change', event => {
    if (!app.device.set('law=' + event.target.value)) {
      refuse(engine.error());
      show_controls();
      return;
    }
    refuse('');
    app.law = event.target.value;
    if (app.question.is_moving) {
      app.laws = [app.law];
      start_runner();
    }
    app.is_own = true;
    evaluate();
    show_controls();
  });
  by_id('scene').addEventListener('change', event => change_setting('scene', scene_text(event.target.value)));
  by_id('map_figure').addEventListener('change', event => {
    app.map_figure = Number(event.target.value);
    paint_map();
    app.is_dirty = true;
  });
  by_id('flip').addEventListener('click', () => {
    if (app.device.flip()) evaluate();
    else say('This device has one pose for each place of its handle.');
  });
  by_id('pause').addEventListener('click', () => set_paused(!app.is_paused));
  by_id('restart').addEventListener('click', restart);
  by_id('self').addEventListener('click', () => set_by_itself(!app.is_by_itself));
  by_id('speed').addEventListener('change', event => set_speed(event.target.value));
  by_id('sound').addEventListener('click', event => {
    sound.turn(!sound.is_on);
    event.target.setAttribute('aria-pressed', String(sound.is_on));
  });
  by_id('record').addEventListener('click', event => toggle_record(event.target));
  by_id('replay').addEventListener('click', () => {
    runner.send({kind: 'replay'});
    set_paused(false);
  });
  by_id('download').addEventListener('click', () => runner.send({kind: 'log', law: app.focus}));
  by_id('copy_link').addEventListener('click', () => {
    const link = own_link();
    history.replaceState(null, '', link);
    copy_text(location.href).then(() => say('The link is copied: ' + location.hash));
  });
  by_id('save_svg').addEventListener('click', () =>
    save_text('explorer.svg', picture_svg(), 'image/svg+xml'),
  );
  by_id('save_png').addEventListener('click', () =>
    save_png('explorer.png', picture_svg(), pen.width, pen.height, 2),
  );
  by_id('theme').addEventListener('click', () =>
    set_theme(document.documentElement.dataset.theme === 'dark' ? 'light' : 'dark'),
  );
  by_id('form').addEventListener('submit', event => event.preventDefault());
  watch_theme(() => {
    app.theme = read_theme();
    app.is_dirty = true;
  });
  watch_files(document.body, by_id('open_log'), open_log);
  addEventListener('hashchange', () => {
    open_link();
    keep_link();
  });
  addEventListener('keydown', shortcut);
  new ResizeObserver(() => {
    app.is_dirty = true;
  }).observe(by_id('stage'));
  document.addEventListener('visibilitychange', () =>
    runner.send({kind: 'pause', is_on: document.hidden || app.is_paused || !is_simulated()}),
  );
}

function set_theme(name) {
  document.documentElement.dataset.theme = name;
}

function shortcut(event) {
  if (
    event.ctrlKey ||
    event.metaKey ||
    event.altKey ||
    /^(INPUT|SELECT|TEXTAREA)$/.test(event.target.tagName)
  )
    return;
  const question = questions[Number(event.key) - 1];
  if (question) location.hash = page_link(question.id);
  else if (!is_moving()) return;
  else if (event.key === ' ' && event.target.tagName !== 'BUTTON' && event.target.tagName !== 'A') {
    event.preventDefault();
    set_paused(!app.is_paused);
  } else if (event.key === 'r') restart();
  else if (event.key === 'h') set_by_itself(!app.is_by_itself);
  else if (event.key === 'Escape') let_go();
}

if (!document.documentElement.dataset.theme && matchMedia('(prefers-color-scheme: dark)').matches)
  set_theme('dark');
app.theme = read_theme();
app.shown = show_controls;
wire();
add_grips();
open_link();
requestAnimationFrame(frame);
document.documentElement.dataset.ready = 'true';
