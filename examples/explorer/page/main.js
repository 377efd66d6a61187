// The page: what was chosen, what follows from it, and the loop that draws.

import { draw_curves } from './curves.js';
import { make_design_map } from './design.js';
import { bytes_of, load_engine } from './engine.js';
import { make_form } from './form.js';
import { element, set_sentence, short_number } from './format.js';
import { make_grips } from './grips.js';
import { copy_text, make_numbers } from './numbers.js';
import { canvas_pen, svg_pen } from './pen.js';
import { box_of, make_picture, margins_of, scales_of } from './picture.js';
import { make_player } from './player.js';
import { make_runner } from './runner.js';
import { save_png, save_text, watch_files } from './save.js';
import { format_settings, page_link, parse_link, parse_settings, settings_link } from './settings.js';
import { make_sound } from './sound.js';
import { arrow_style, draw_stage } from './stage.js';
import { layers, laws_answer, moment_answer, questions, result_columns, still_answer } from './story.js';
import { read_theme, watch_theme } from './theme.js';

const by_id = id => document.getElementById(id);
const preset_of = id => engine.catalogue.presets.find(preset => preset.id === id);

const code = by_id("engine-code").textContent, bytes = await bytes_of(by_id("engine-wasm").textContent);
const engine = await load_engine(code, bytes);

const app = {
  question: questions[0], preset: null, device: null, info: null, laws: [], focus: 0, layers: new Set(), is_own: false, theme: read_theme(),
  yaw: 0.6, pitch: 0.5, pointer: null, is_held: false, is_paused: false, is_by_itself: true, is_dirty: true, map: null, map_figure: 0, log: null, lens_memory: {},
};
const pen = canvas_pen(by_id("picture")), curves_pen = canvas_pen(by_id("curves")), sound = make_sound();
const runner = make_runner(code, bytes, by_id("worker-code").textContent, {
  started() { app.is_dirty = true; },
  refused: ({reason}) => refuse(reason),
  replayed() { set_paused(true); say("The recorded motion has ended."); },
  log({text, command}) {
    save_text("explorer_log.csv", text, "text/csv");
    say("explorer_log.csv is a log of the library. It replays with: " + command);
  },
});
const design = make_design_map(() => { paint_map(); app.is_dirty = true; });
const show_numbers = make_numbers(by_id("numbers"), text => speak("Copied " + text));
const form = make_form(by_id("form"), change_setting);
const grips = make_grips(by_id("handles"));

// --- What is shown -----------------------------------------------------------------------------------------------------------

// Opens what a link names; without one, the hand along a wall.
function open_link() {
  const {page, settings} = parse_link(location.hash);
  if (settings) {
    const question = questions.find(other => other.id === settings.get("page")) || questions[1];
    settings.delete("page");
    return begin(question, format_settings(settings), null, true);
  }
  const preset = preset_of(page);
  if (preset) return begin(question_of(preset), preset.settings, preset, false);
  return ask(questions.find(question => question.id === page) || questions[0]);
}

// The question that a figure of the paper belongs to.
function question_of(preset) {
  const settings = parse_settings(preset.settings);
  if (settings.get("hand") === "along") return questions[4];
  return settings.get("desired") === "given" || (settings.get("scene") || "none") !== "none" ? questions[2] : questions[1];
}

// Goes to a question, with the device that was chosen, or with that of the question.
function ask(question) {
  if (app.is_own && app.device) {
    const settings = parse_settings(app.device.settings());
    settings.set("desired", question.id === "wanted" ? "given" : "scene");
    settings.set("hand", question.is_moving ? "along" : "pointer");
    return begin(question, format_settings(settings), null, true);
  }
  const settings = parse_settings(preset_of(question.preset)?.settings || "mechanism=" + engine.catalogue.mechanisms[0].id + (question.is_moving ? "\nhand=along" : ""));
  if (!question.is_moving) settings.set("hand", "pointer");
  begin(question, format_settings(settings), null, false);
}

function begin(question, settings, preset, is_own) {
  const device = engine.device(settings);
  if (!device) { refuse(engine.error()); if (app.device) return; return ask(questions[0]); }
  refuse("");
  const is_new_question = question !== app.question || !app.device;
  app.device?.end();
  app.log?.end();
  Object.assign(app, {device, question, preset, is_own, log: null, pointer: null, is_held: false, lens_memory: {}});
  const lines = parse_settings(device.settings()), mechanism = lines.get("mechanism") || engine.catalogue.mechanisms[0].id;
  app.info = engine.catalogue.mechanisms.find(other => other.id === mechanism);
  app.law = lines.get("law") || form_value("law");
  if (is_new_question || preset) app.layers = new Set(question.layers);
  if (app.info.dimension === 3) app.layers.delete("others");
  if (preset) app.laws = question.is_moving ? preset_laws(app.law) : [];
  else if (is_new_question) app.laws = [...(question.laws || [])];
  app.is_by_itself = question.is_moving;
  if (question.is_moving && app.laws.length === 1) app.law = app.laws[0];
  device.evaluate();
  if (question.id === "wanted" && !Math.hypot(...device.value("Fd"))) want_something();
  app.bounds = device.bounds();
  app.box = box_of(device, app.info, question.id === "mine");
  app.scales = scales_of(device, app.info);
  app.begun = (app.begun || 0) + 1;
  app.is_hollow = form_value("scene").startsWith("hollow");
  app.map = null;
  design.end();
  if (question.is_moving) {
    if (is_new_question) set_speed(question.speed || "1");
    set_paused(matchMedia("(prefers-reduced-motion: reduce)").matches);
    start_runner();
  } else runner.send({kind: "pause", is_on: true});
  if (question.id === "mine") begin_map();
  show_controls();
  app.is_dirty = true;
}

const preset_laws = law => law === "no_direct_control" ? [law] : ["no_direct_control", law];

// A force to begin with where none is wanted: halfway between two reference forces.
function want_something() {
  const R = app.device.value("R"), limits = app.device.value("torque_limit"), state = app.device.state(app.info.joints);
  for (let i = 0; i < 3; ++i) state.Fd[i] = 0.5 * (limits[0] * R[i] - limits[1] * R[3 + i]);
  app.device.set("desired=given");
  app.device.evaluate();
}

function start_runner() {
  const text = app.device.settings(), x = app.device.value("x");
  assign_colors();
  app.focus = Math.max(0, app.laws.length - 1);
  runner.start(app.laws.map(law => text + "\nlaw=" + law), app.laws, x);
}

function assign_colors() {
  const slots = new Map(), free = [0, 1, 2], fixed = {no_direct_control: 0, velocity_direct_control: 1};
  const take = (law, slot) => { slots.set(law, slot); free.splice(free.indexOf(slot), 1); };
  for (const law of app.laws) if (law in fixed) take(law, fixed[law]);
  for (const law of app.laws) if (!slots.has(law)) take(law, free.at(-1));
  app.slots = app.laws.map(law => slots.get(law));
}

const colors = () => app.slots.map(slot => app.theme.laws[slot]);
const form_value = name => app.device.form().find(entry => entry.name === name)?.value ?? "";
const law_label = law => engine.catalogue.laws.find(other => other.id === law)?.label || law.replaceAll("_", " ");

// --- Values ------------------------------------------------------------------------------------------------------------------

// The rows that are shown: of the log that is played, or of the simulation.
const tracks = () => app.log ? app.log.tracks : app.question.is_moving ? runner.tracks : null;
const is_simulated = () => app.question.is_moving && !app.log;
const is_moving = () => !!app.log || !!app.question.is_moving;

function value(id) {
  const number = tracks()?.value(app.focus, id);
  if (number) return number;
  if (is_moving() && id === "Fc_scaled") return tracks()?.value(app.focus, "Fc")?.map(c => c * tracks().value(app.focus, "alpha")[0]) || [0, 0, 0];
  return app.device.value(id);
}

function word(id, k) { return tracks()?.value(app.focus, id) ? tracks().word(app.focus, id, k) : app.device.word(id, k); }

function brake_states() {
  const torques = tracks()?.value(app.focus, "brake_torque") || app.device.value("torque"), limits = app.device.value("torque_limit");
  return torques.map((torque, k) => {
    const state = word("brake_state", k) || "released";
    return {state, share: Math.abs(torque) / limits[k], text: state === "released" ? state : state + ", " + short_number(Math.abs(torque), 2) + " N m"};
  });
}

// The device takes the state of the last row.
function follow_tracks() {
  const q = tracks()?.value(app.focus, "q");
  if (!q) return;
  const state = app.device.state(app.info.joints);
  state.q.set(q);
  state.qd.set(tracks().value(app.focus, "qd"));
  state.Fh.set(tracks().value(app.focus, "hand_force"));
  app.device.evaluate();
}

// --- Drawing -----------------------------------------------------------------------------------------------------------------

function view_of(width, height) {
  const margins_key = [width, height, app.begun].join();
  if (app.margins_key !== margins_key) {
    app.margins_key = margins_key;
    app.margins = margins_of({device: app.device, info: app.info, scales: app.scales, bounds: app.box, width, height, layers: app.layers, is_moving: is_moving()});
  }
  return {margins: app.margins, is_hollow: app.is_hollow, device: app.device, info: app.info, scales: app.scales, bounds: app.box, width, height, yaw: app.yaw, pitch: app.pitch, is_moving: is_moving() && !!tracks(), tracks: tracks(),
    focus: app.focus, colors: is_moving() ? colors() : [], value, layers: app.layers, brakes: brake_states(), pointer: app.is_held ? app.pointer : null,
    lens_memory: app.lens_memory, map: app.map, shows_hand: is_simulated() && !app.is_held && app.is_by_itself};
}

function draw() {
  if (is_moving()) follow_tracks();
  pen.begin();
  if (!pen.width) return;
  const view = view_of(pen.width, pen.height);
  app.picture = make_picture(view);
  draw_stage(pen, app.picture, app.theme);
  place_grips();
  if (tracks()) {
    curves_pen.begin();
    draw_curves(curves_pen, tracks(), app.log ? null : runner.last, app.theme, tracks().laws.map(law_label), colors(), app.info.brakes, app.question.id === "watch");
    sound.play(tracks().value(app.focus, "sound")?.[0] || 0);
  }
}

let last_slow = 0;

function frame(now) {
  requestAnimationFrame(frame);
  const is_running = !app.is_paused && tracks();
  if (app.log && is_running) play_log(now);
  if (is_running && is_simulated() && app.is_by_itself && is_way_done()) { app.lens_memory = {}; runner.again(); }
  if (!app.is_dirty && !is_running) return;
  const is_slow_turn = app.is_dirty || now - last_slow > 200;
  app.is_dirty = false;
  draw();
  if (is_slow_turn) { last_slow = now; show_texts(); }
}

// Whether the hand by itself came to the end of its way, under all laws, or well beyond under one.
function is_way_done() {
  const shares = app.laws.map((_, law) => tracks().value(law, "progress")?.[0] ?? 0);
  return Math.min(...shares) >= 1 || Math.max(...shares) >= 1.05;
}

// Sentences and numbers, a few times a second.
function show_texts() {
  const brakes = brake_states();
  if (tracks()) {
    set_sentence(by_id("answer"), tracks().laws.length < 2 ? moment_answer(tracks(), app.focus, brakes) : laws_answer(tracks(), new Map(app.laws.map(law => [law, law_label(law)])), runner.last?.figures));
    show_numbers(tracks().layout.values, entry => tracks().value(app.focus, entry.id) || Array(entry.size).fill(NaN));
    show_results();
  } else {
    set_sentence(by_id("answer"), app.question.id === "mine" ? map_answer() : still_answer(app.question.id, value, word, brakes));
    show_numbers(app.device.layout, entry => app.device.value(entry.id));
  }
  by_id("late").hidden = !(is_simulated() && runner.is_late && !app.is_paused);
  by_id("late").textContent = "This machine is slower than real time: the simulation lags.";
  name_grips();
}

function show_results() {
  const target = by_id("results");
  target.hidden = app.laws.length < 2 || !!app.log;
  if (target.hidden || !tracks().figures.length) return;
  const key = app.laws.join();
  if (target.dataset.key !== key) {
    target.dataset.key = key;
    target.replaceChildren(element("table", {}, element("thead", {}, element("tr", {}, element("th", {scope: "col", text: "law"}),
      ...result_columns.map(column => element("th", {scope: "col", text: column.title + " [" + column.unit + "]"})))), element("tbody", {}, ...app.laws.map((law, k) => element("tr", {},
      element("th", {scope: "row"}, element("span", {class: "swatch", style: "display:inline-block;margin-right:8px;vertical-align:middle;background:var(--law-" + (app.slots[k] + 1) + ")"}), law_label(law)), ...result_columns.map(() => element("td")))))));
  }
  [...target.querySelectorAll("tbody tr")].forEach((row, k) => [...row.querySelectorAll("td")].forEach((cell, c) => {
    const figures = tracks().figures[k], column = result_columns[c];
    cell.textContent = figures ? short_number(figures[column.of] * column.factor, 3) : "–";
  }));
}

// --- Grips -------------------------------------------------------------------------------------------------------------------

const stub = {v: [0, 40], Fh: [32, -28], Fd: [-40, 0]};  // where a grip waits while its arrow is too short to be taken [pixels]

function add_grips() {
  let from = null;
  grips.add({id: "scene", className: "scene",
    grabbed(pixel) { from = pixel; if (!is_space()) { take_hand(); move_handle(app.picture.camera.back(pixel, app.picture.handle)); } },
    moved(pixel) {
      if (!is_space()) return move_handle(app.picture.camera.back(pixel, app.picture.handle));
      turn_view(0.008 * (pixel[0] - from[0]), 0.008 * (pixel[1] - from[1]));
      from = pixel;
    },
    released: let_go,
    keyed([x, y]) { is_space() ? turn_view(-0.08 * x, -0.08 * y) : nudge_handle([x, y, 0]); }});
  grips.add({id: "handle", grabbed: take_hand, moved: pixel => move_handle(app.picture.camera.back(pixel, app.picture.handle)), released: let_go, keyed: nudge_handle});
  for (const id of ["v", "Fh", "Fd"]) grips.add({id, moved: pixel => turn_arrow(id, pixel), keyed: move => push_arrow(id, move)});
}

const is_space = () => app.info.dimension === 3;

function turn_view(yaw, pitch) {
  app.yaw -= yaw;
  app.pitch = Math.min(1.5, Math.max(-0.2, app.pitch + pitch));
  app.is_dirty = true;
}

function place_grips() {
  const {picture} = app, at = picture.handle && picture.camera.point(picture.handle);
  grips.place("handle", at);
  for (const id of ["v", "Fh", "Fd"]) {
    const arrow = picture.arrows.find(other => other.id === id);
    const is_free = at && !is_moving() && app.layers.has(id) && (id !== "Fd" || app.question.id === "wanted");
    if (!is_free) { grips.place(id, null); continue; }
    const head = arrow?.head && Math.hypot(arrow.head[0] - at[0], arrow.head[1] - at[1]) > 24 ? arrow.head : null, place = head || [at[0] + stub[id][0], at[1] + stub[id][1]];
    if (!head) {
      const style = arrow_style(id, app.theme);
      pen.path(`M${at[0]} ${at[1]}L${place[0]} ${place[1]}`, {stroke: style.color, width: 1.2, dash: [2, 4], alpha: 0.8});
      pen.path(`M${place[0] - 5} ${place[1]}a5 5 0 1 0 10 0a5 5 0 1 0 -10 0Z`, {fill: app.theme.paper, stroke: style.color, width: 2});
      pen.label(id === "v" ? "v" : "F_{" + id[1] + "}", place[0] + 9, place[1] + 5, {size: 15, math: true, weight: 600, color: style.color, halo: app.theme.paper});
    }
    grips.place(id, place.map((c, i) => Math.min((i ? pen.height : pen.width) - 12, Math.max(12, c))));
  }
}

function name_grips() {
  const text = (vector, factor, unit) => ["x", "y", "z"].slice(0, app.info.dimension).map((axis, i) => axis + " " + short_number(vector[i] * factor, 3)).join(", ") + " " + unit;
  grips.name("scene", is_space() ? "View in space, turned by the arrow keys" : "Picture of the device. The arrow keys move the handle");
  grips.name("handle", "Handle at " + text(value("x"), 100, "cm"));
  grips.name("v", "Velocity, " + text(value("v"), 1, "m/s"));
  grips.name("Fh", "Hand force, " + text(app.device.value("Fh"), 1, "N"));
  grips.name("Fd", "Wanted force, " + text(app.device.value("Fd"), 1, "N"));
}

// The visitor takes the handle: the hand by itself lets go.
function take_hand() {
  by_id("hint").hidden = true;
  if (!is_simulated()) return;
  app.is_held = true;
  app.pointer = value("x");
  if (app.is_by_itself) {
    app.is_by_itself = false;
    runner.send({kind: "settings", text: "hand=pointer"});
    by_id("self").setAttribute("aria-pressed", "false");
  }
  if (app.is_paused) set_paused(false);
}

function let_go() {
  if (!is_simulated()) return;
  app.is_held = false;
  send_pointer();
}

function send_pointer() { runner.send({kind: "pointer", point: app.pointer || value("x"), is_held: app.is_held}); }

function move_handle(point) {
  if (app.log) return;
  if (is_simulated()) {
    app.pointer = point;
    return send_pointer();
  }
  const v = app.device.value("v");
  app.device.reach(point);
  app.device.move(v);
  evaluate();
}

function nudge_handle(move) {
  const step = 0.008 * app.scales.reach;
  if (is_simulated() && !app.is_held) take_hand();
  const from = is_simulated() ? app.pointer : app.device.value("x");
  move_handle(from.map((c, i) => c + step * move[i]));
}

function turn_arrow(id, pixel) {
  const {camera, handle} = app.picture, at = camera.point(handle), scale = id === "v" ? app.picture.motion_scale : app.picture.force_scale;
  const old = app.device.value(id), depth = old[0] * camera.towards[0] + old[1] * camera.towards[1] + old[2] * camera.towards[2];
  let d = [pixel[0] - at[0], pixel[1] - at[1]];
  if (Math.hypot(...d) < 14) d = [0, 0];
  set_arrow(id, camera.back_vector(d.map(c => c / scale)).map((c, i) => c + depth * camera.towards[i]));
}

function push_arrow(id, move) {
  const step = 8 / (id === "v" ? app.picture.motion_scale : app.picture.force_scale), old = app.device.value(id);
  set_arrow(id, old.map((c, i) => c + step * move[i]));
}

function set_arrow(id, vector) {
  if (id === "v") app.device.move(vector);
  else {
    if (id === "Fd") app.device.set("desired=given");
    app.device.state(app.info.joints)[id].set(vector);
  }
  evaluate();
}

function evaluate() {
  app.device.evaluate();
  app.is_dirty = true;
  app.is_moved = true;
  app.preset = null;
  keep_link();
}

// --- Controls ----------------------------------------------------------------------------------------------------------------

function show_controls() {
  const {question} = app;
  set_sentence(by_id("lead"), app.preset ? app.preset.title + ". " + app.preset.look : question.lead);
  for (const link of by_id("questions").children) mark_current(link, link.dataset.id === question.id);
  for (const link of by_id("presets").children) mark_current(link, app.preset?.id === link.dataset.id);
  by_id("mechanism").value = app.info.id;
  by_id("law").value = app.law;
  show_scene();
  const beside = question.id === "watch" || question.id === "laws";
  by_id("laws").hidden = !beside;
  by_id("law_choice").hidden = beside;
  by_id("law_text").hidden = beside;
  const law = engine.catalogue.laws.find(other => other.id === app.law);
  by_id("law_text").textContent = law ? law.look + (law.equation ? " Equation (" + law.equation + ")." : "") : "";
  show_laws();
  for (const id of ["transport", "plots"]) by_id(id).hidden = !is_moving();
  document.body.dataset.question = question.id;
  document.body.classList.toggle("moving", is_moving());
  by_id("results").hidden = app.laws.length < 2 || !question.is_moving;
  by_id("map_choice").hidden = question.id !== "mine";
  by_id("flip").hidden = question.is_moving;
  if (question.opens_form) by_id("form_details").open = true;
  by_id("self").setAttribute("aria-pressed", String(app.is_by_itself));
  by_id("hint").hidden = !(question.id === "watch" && app.is_by_itself);
  by_id("hint").textContent = "Take the handle: drag it, or press Tab and the arrow keys";
  show_form();
  show_legend();
}

function mark_current(link, is_current) { is_current ? link.setAttribute("aria-current", "page") : link.removeAttribute("aria-current"); }

function show_form() { form.show(app.device.form(), ["mechanism", "brakes", "law", "options", "scene", "hand"]); }

function show_scene() {
  const text = form_value("scene"), select = by_id("scene"), kind = text.split(":")[0];
  const fitting = engine.catalogue.scenes.filter(scene => scene.dimensions.includes(app.info.dimension));
  select.replaceChildren(...fitting.map(scene => element("option", {value: scene.id, text: scene.label})));
  select.value = kind || "none";
}

// A wall of this kind a little beyond the handle.
function scene_text(kind) {
  if (kind === "none") return kind;
  const x = app.device.value("x").slice(0, app.info.dimension), reach = app.scales.reach, y = x.map((c, i) => c + (i === 1 ? 0.02 * reach : 0));
  const along = (i, way) => y.map((c, k) => c + (k === i ? way : 0)), up = x.map((_, i) => i === 1 ? -1 : 0);
  const numbers = {
    plane: () => [...y, ...up], solid: () => [...along(1, 0.25 * reach), 0.25 * reach], hollow: () => [...along(1, -0.3 * reach), 0.3 * reach],
    edge: () => [...y, -0.6, -0.8, 0.6, -0.8], outline: () => [[-0.2, 0.02], [0, 0], [0.2, 0.02], [0.12, 0.2], [-0.12, 0.2]].flatMap(([a, b]) => [y[0] + a * reach, y[1] + b * reach]),
    box: () => [...x.map((c, i) => c - (i === 1 ? -0.02 : 0.15) * reach), ...x.map((c, i) => c + (i === 1 ? 0.2 : 0.15) * reach)],
  }[kind]();
  return kind + ":" + numbers.map(c => Number(c.toPrecision(4))).join();
}

function show_laws() {
  by_id("law_list").replaceChildren(...engine.catalogue.laws.map(law => {
    const at = app.laws.indexOf(law.id);
    const box = element("input", {type: "checkbox", value: law.id, checked: at >= 0, onchange: () => toggle_law(law.id)});
    box.checked = at >= 0;
    return element("label", {title: law.look}, box, element("span", {class: "swatch", style: at >= 0 && app.slots ? "background:var(--law-" + (app.slots[at] + 1) + ")" : ""}), law.label);
  }));
}

function toggle_law(law) {
  if (app.laws.includes(law)) { if (app.laws.length > 1) app.laws = app.laws.filter(other => other !== law); }
  else app.laws = [...app.laws, law].slice(-3);
  start_runner();
  show_laws();
  by_id("law_list").querySelector(`input[value="${law}"]`)?.focus();
}

function show_legend() {
  const moving_only = ["paths"], is_used = id => (id !== "map" || app.question.id === "mine") && (!moving_only.includes(id) || app.question.is_moving);
  by_id("legend").replaceChildren(...layers.filter(layer => is_used(layer.id)).map(layer => {
    const button = element("button", {type: "button", "aria-pressed": String(app.layers.has(layer.id)), "data-layer": layer.id});
    button.innerHTML = legend_mark(layer.style);
    button.append(element("span", {}, ...layer.label.split(/(_\{[^}]*\})/).map(part => part.startsWith("_{") ? element("sub", {text: part.slice(2, -1)}) : part)));
    button.addEventListener("click", () => {
      app.layers.has(layer.id) ? app.layers.delete(layer.id) : app.layers.add(layer.id);
      button.setAttribute("aria-pressed", String(app.layers.has(layer.id)));
      app.is_dirty = true;
    });
    return button;
  }));
}

function legend_mark(style) {
  const line = (name, width, dash) => `<svg aria-hidden="true" viewBox="0 0 26 12"><path d="M1 6H18" stroke="var(--${name})" stroke-width="${width}"${dash ? ` stroke-dasharray="${dash}"` : ""} fill="none"/><path d="M25 6 16 1.5 18 6 16 10.5Z" fill="var(--${name})"/></svg>`;
  const area = name => `<svg aria-hidden="true" viewBox="0 0 26 12"><path d="M2 10 13 1 24 8Z" fill="var(--${name})" fill-opacity=".35" stroke="var(--${name})"/></svg>`;
  return {cone: area("cone"), others: area("faint"), references: line("muted", 1.4, "4 3"), Fd: line("wanted", 2), Fc_scaled: line("made", 4), v: line("motion", 3), Fh: line("hand", 3), Fr: line("result", 2, "5 2")}[style] || "";
}

function change_setting(name, text) {
  const line = name + "=" + text;
  if (!app.device.set(line)) { refuse(engine.error()); show_form(); return; }
  refuse("");
  app.is_own = true;
  const settings = app.device.settings();
  if (app.question.is_moving && !name.startsWith("mechanism.")) {
    runner.send({kind: "settings", text: line});
    app.device.evaluate();
    show_controls();
    app.is_dirty = true;
  } else begin(app.question, settings, null, true);
  keep_link();
}

function refuse(reason) {
  by_id("refused").hidden = !reason;
  by_id("refused").textContent = reason;
}

function say(text) {
  by_id("note").hidden = !text;
  by_id("note").textContent = text;
}

function speak(text) { by_id("spoken").textContent = text; }

// The link follows what is shown, without an entry in the history.
let link_timer = 0;
function keep_link() {
  clearTimeout(link_timer);
  link_timer = setTimeout(() => history.replaceState(null, "", own_link()), 300);
}

function own_link() {
  if (app.preset) return page_link(app.preset.id);
  if (!app.is_own && !app.is_moved) return page_link(app.question.id);
  const settings = parse_settings(app.device.settings());
  return settings_link(new Map([["page", app.question.id], ...settings]));
}

function set_paused(is_on) {
  app.is_paused = is_on;
  by_id("pause").setAttribute("aria-pressed", String(is_on));
  by_id("pause").textContent = is_on ? "Play" : "Pause";
  if (!app.log) runner.send({kind: "pause", is_on});
  else if (!is_on && app.log.is_ended) app.log.restart();
  app.is_dirty = true;
}

function set_speed(factor) {
  by_id("speed").value = factor;
  runner.send({kind: "speed", factor: Number(factor)});
}

function set_by_itself(is_on) {
  app.is_by_itself = is_on;
  by_id("self").setAttribute("aria-pressed", String(is_on));
  runner.send({kind: "settings", text: "hand=" + (is_on ? "along" : "pointer")});
}

function restart() {
  app.lens_memory = {};
  app.log ? app.log.restart() : runner.again();
  if (app.is_paused) set_paused(false);
}

// --- Design map --------------------------------------------------------------------------------------------------------------

function begin_map() {
  if (!design.begin(app.device, app.bounds)) refuse(engine.error());
  paint_map();
}

function paint_map() {
  app.map = design.picture(app.map_figure, engine.catalogue.figures[app.map_figure]);
}

function map_answer() {
  if (!app.map || !app.map.known.length) return "The map is being computed.";
  const {known} = app.map, figure = engine.catalogue.figures[app.map_figure], unit = figure.unit && figure.unit !== "1" ? " " + figure.unit : "";
  return figure.look + " Over all places that it reaches the median is *" + short_number(known[known.length >> 1], 3) + unit + "*, the least *" + short_number(known[0], 3) + unit + "*.";
}

// --- Wiring ------------------------------------------------------------------------------------------------------------------

function wire() {
  by_id("questions").append(...questions.map(question => element("a", {href: page_link(question.id), "data-id": question.id}, element("b", {text: question.mark, "aria-hidden": "true"}), question.title)));
  by_id("presets").append(...engine.catalogue.presets.map(preset => element("a", {href: page_link(preset.id), "data-id": preset.id, title: preset.look}, preset.title)));
  by_id("mechanism").append(...engine.catalogue.mechanisms.map(mechanism => element("option", {value: mechanism.id, text: mechanism.label})));
  by_id("law").append(...engine.catalogue.laws.map(law => element("option", {value: law.id, text: law.label})));
  by_id("map_figure").append(...engine.catalogue.figures.map((figure, k) => element("option", {value: k, text: figure.label})));
  by_id("mechanism").addEventListener("change", event => begin(app.question, "mechanism=" + event.target.value + "\nhand=" + (app.question.is_moving ? "along" : "pointer") + "\ndesired=" + (app.question.id === "wanted" ? "given" : "scene"), null, true) || keep_link());
  by_id("law").addEventListener("change", event => {
    app.law = event.target.value;
    app.device.set("law=" + app.law);
    if (app.question.is_moving) { app.laws = [app.law]; start_runner(); }
    app.is_own = true;
    evaluate();
    show_controls();
  });
  by_id("scene").addEventListener("change", event => change_setting("scene", scene_text(event.target.value)));
  by_id("map_figure").addEventListener("change", event => { app.map_figure = Number(event.target.value); paint_map(); app.is_dirty = true; });
  by_id("flip").addEventListener("click", () => { if (app.device.flip()) evaluate(); else say("This device has one pose for each place of its handle."); });
  by_id("pause").addEventListener("click", () => set_paused(!app.is_paused));
  by_id("restart").addEventListener("click", restart);
  by_id("self").addEventListener("click", () => set_by_itself(!app.is_by_itself));
  by_id("speed").addEventListener("change", event => set_speed(event.target.value));
  by_id("sound").addEventListener("click", event => { sound.turn(!sound.is_on); event.target.setAttribute("aria-pressed", String(sound.is_on)); });
  by_id("record").addEventListener("click", event => toggle_record(event.target));
  by_id("replay").addEventListener("click", () => { runner.send({kind: "replay"}); set_paused(false); });
  by_id("download").addEventListener("click", () => runner.send({kind: "log", law: app.focus}));
  by_id("copy_link").addEventListener("click", () => { const link = own_link(); history.replaceState(null, "", link); copy_text(location.href).then(() => say("The link is copied: " + location.hash)); });
  by_id("save_svg").addEventListener("click", () => save_text("explorer.svg", picture_svg(), "image/svg+xml"));
  by_id("save_png").addEventListener("click", () => save_png("explorer.png", picture_svg(), pen.width, pen.height, 2));
  by_id("theme").addEventListener("click", () => set_theme(document.documentElement.dataset.theme === "dark" ? "light" : "dark"));
  by_id("form").addEventListener("submit", event => event.preventDefault());
  watch_theme(() => { app.theme = read_theme(); app.is_dirty = true; });
  watch_files(document.body, by_id("open_log"), open_log);
  addEventListener("hashchange", open_link);
  addEventListener("keydown", shortcut);
  new ResizeObserver(() => { app.is_dirty = true; }).observe(by_id("stage"));
  document.addEventListener("visibilitychange", () => runner.send({kind: "pause", is_on: document.hidden || app.is_paused || !is_simulated()}));
}

function set_theme(name) { document.documentElement.dataset.theme = name; }

function picture_svg() {
  const drawing = svg_pen(pen.width, pen.height, app.theme.paper);
  draw_stage(drawing, make_picture(view_of(pen.width, pen.height)), app.theme);
  return drawing.text();
}

function toggle_record(button) {
  const is_on = button.getAttribute("aria-pressed") !== "true";
  button.setAttribute("aria-pressed", String(is_on));
  button.textContent = is_on ? "Stop recording" : "Record";
  if (is_on) restart();
  runner.send({kind: "record", is_on});
  if (!is_on) for (const id of ["replay", "download"]) by_id(id).disabled = false;
}

// Plays a log of the library through the law that is chosen.
function open_log(text, name) {
  const log = engine.open_log(app.device.settings() + "\nlaw=" + (app.laws[app.focus] || app.law), text);
  if (!log) return say(name + ": " + engine.error());
  const [equal, all] = log.agreement(), law = app.laws[app.focus] || app.law;
  app.log?.end();
  app.log = make_player(log, law);
  app.laws = [law];
  app.focus = 0;
  assign_colors();
  runner.send({kind: "pause", is_on: true});
  say(name + ": " + log.count() + " lines" + (all ? "; " + equal + " of " + all + " capacities are those of " + law_label(law) + " to the last digit." : "."));
  set_paused(false);
  show_controls();
}

let last_played = 0;

function play_log(now) {
  const passed = Math.min(0.1, (now - last_played) / 1000);
  last_played = now;
  app.log.advance(passed * Number(by_id("speed").value));
  if (app.log.is_ended) set_paused(true);
}

function shortcut(event) {
  if (event.ctrlKey || event.metaKey || event.altKey || /^(INPUT|SELECT|TEXTAREA)$/.test(event.target.tagName)) return;
  const question = questions[Number(event.key) - 1];
  if (question) location.hash = page_link(question.id);
  else if (!is_moving()) return;
  else if (event.key === " " && event.target.tagName !== "BUTTON" && event.target.tagName !== "A") { event.preventDefault(); set_paused(!app.is_paused); }
  else if (event.key === "r") restart();
  else if (event.key === "h") set_by_itself(!app.is_by_itself);
  else if (event.key === "Escape") let_go();
}

if (!document.documentElement.dataset.theme && matchMedia("(prefers-color-scheme: dark)").matches) set_theme("dark");
app.theme = read_theme();
wire();
add_grips();
open_link();
requestAnimationFrame(frame);
document.documentElement.dataset.ready = "true";
