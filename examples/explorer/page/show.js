// The loop that draws: the picture and the curves in each frame, sentences and numbers a few times a
// second.

import {
  app,
  brake_states,
  colors,
  engine,
  follow_tracks,
  form_value,
  is_moving,
  is_simulated,
  pen,
  runner,
  tracks,
  value,
  word,
} from './app.js';
import {draw_curves} from './curves.js';
import {element, set_sentence, short_number} from './format.js';
import {name_grips, place_grips} from './hand.js';
import {by_id, speak} from './messages.js';
import {make_numbers} from './numbers.js';
import {canvas_pen, svg_pen} from './pen.js';
import {make_picture, margins_of} from './picture.js';
import {make_sound} from './sound.js';
import {draw_stage} from './stage.js';
import {design_sentence, laws_sentence, moment_sentence, result_columns, still_sentence} from './story.js';
import {is_way_done, play_log} from './transport.js';

const curves_pen = canvas_pen(by_id('curves')),
  show_numbers = make_numbers(by_id('numbers'), text => speak('Copied ' + text));
export const sound = make_sound();
let last_slow = 0,
  is_even = false; // the curves are drawn in every other frame

function view_of(width, height) {
  const margins_key = [width, height, app.begun].join();
  if (app.margins_key !== margins_key) {
    app.margins_key = margins_key;
    app.margins = margins_of({
      device: app.device,
      info: app.info,
      scales: app.scales,
      bounds: app.box,
      width,
      height,
      layers: app.layers,
      is_moving: is_moving(),
    });
  }
  const brakes = brake_states();
  if (width < 520) for (const brake of brakes) brake.text = brake.state; // there is no room for more
  return {
    margins: app.margins,
    is_hollow: app.is_hollow,
    device: app.device,
    info: app.info,
    scales: app.scales,
    bounds: app.box,
    width,
    height,
    yaw: app.yaw,
    pitch: app.pitch,
    is_moving: is_moving() && !!tracks(),
    tracks: tracks(),
    focus: app.focus,
    colors: is_moving() ? colors() : [],
    value,
    layers: app.layers,
    brakes,
    pointer: app.is_held ? app.pointer : null,
    lens_memory: app.lens_memory,
    map: app.map,
    shows_hand: is_simulated() && !app.is_held && app.is_by_itself,
  };
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
    draw_curves(
      curves_pen,
      tracks(),
      app.log ? null : runner.last,
      app.theme,
      tracks().laws,
      colors(),
      app.info.brakes,
      app.question.id === 'watch',
    );
    sound.play(tracks().value(app.focus, 'sound')?.[0] || 0);
  }
}

export function frame(now) {
  requestAnimationFrame(frame);
  const is_running = !app.is_paused && tracks();
  if (app.log && is_running) play_log(now);
  if (
    is_running &&
    is_simulated() &&
    app.is_by_itself &&
    !app.is_recording &&
    !runner.is_replay &&
    is_way_done()
  ) {
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
  const brakes = brake_states();
  if (tracks()) {
    set_sentence(
      by_id('answer'),
      tracks().laws.length < 2
        ? moment_sentence(tracks(), app.focus, brakes)
        : laws_sentence(tracks(), runner.last?.figures),
    );
    show_numbers(
      tracks().layout.values,
      entry => tracks().value(app.focus, entry.id) || Array(entry.size).fill(NaN),
    );
    show_results();
  } else {
    set_sentence(
      by_id('answer'),
      app.question.id === 'mine'
        ? map_sentence()
        : still_sentence(
            app.question.id,
            value,
            word,
            brakes,
            Number(form_value('options.max_approximation_angle')),
          ),
    );
    show_numbers(app.device.layout, entry => app.device.value(entry.id));
  }
  by_id('late').hidden = !(is_simulated() && runner.is_late() && !app.is_paused);
  by_id('late').textContent = 'This machine is slower than real time: the simulation lags.';
  name_grips();
}

function show_results() {
  const target = by_id('results');
  target.hidden = app.laws.length < 2 || !!app.log;
  if (target.hidden || !tracks().figures.length) return;
  const key = app.laws.join();
  if (target.dataset.key !== key) {
    target.dataset.key = key;
    target.replaceChildren(
      element(
        'table',
        {},
        element(
          'thead',
          {},
          element(
            'tr',
            {},
            element('th', {scope: 'col', text: 'law'}),
            ...result_columns.map(column =>
              element('th', {scope: 'col', text: column.title + ' [' + column.unit + ']'}),
            ),
          ),
        ),
        element(
          'tbody',
          {},
          ...app.laws.map((law, k) =>
            element(
              'tr',
              {},
              element(
                'th',
                {scope: 'row'},
                element('span', {class: 'swatch', style: 'background:var(--law-' + (app.slots[k] + 1) + ')'}),
                element(
                  'button',
                  {
                    type: 'button',
                    class: 'plain',
                    title: 'Draw the device of this law',
                    onclick: () => {
                      app.focus = k;
                      app.is_dirty = true;
                    },
                  },
                  law,
                ),
              ),
              ...result_columns.map(() => element('td')),
            ),
          ),
        ),
      ),
    );
  }
  target
    .querySelectorAll('tbody .plain')
    .forEach((button, k) => button.setAttribute('aria-pressed', String(k === app.focus)));
  [...target.querySelectorAll('tbody tr')].forEach((row, k) =>
    [...row.querySelectorAll('td')].forEach((cell, c) => {
      const figures = tracks().figures[k],
        column = result_columns[c];
      cell.textContent =
        figures && (column.of < 2 || figures[7] > 1)
          ? short_number(figures[column.of] * column.factor, 3)
          : '–';
    }),
  );
}

function map_sentence() {
  const {map} = app,
    figure = engine.catalogue.figures[app.map_figure];
  return map
    ? design_sentence(
        figure,
        map.known,
        map.classes,
        app.device.layout.find(entry => entry.id === 'display').words,
        {direction: form_value('map.direction'), normal: form_value('map.normal')},
      )
    : '';
}

export function picture_svg() {
  const drawing = svg_pen(pen.width, pen.height, app.theme.paper);
  draw_stage(drawing, make_picture(view_of(pen.width, pen.height)), app.theme);
  return drawing.text();
}
