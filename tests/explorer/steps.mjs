// What the steps of the page draw and say, with the engine in WebAssembly and without a browser.
//
// usage: node steps.mjs FOLDER_OF_THE_ENGINE
import {readFileSync} from 'node:fs';
import {load} from './load.mjs';
import {device_file_of, settings_of_file} from '../../examples/explorer/page/device_file.js';
import {short_number} from '../../examples/explorer/page/format.js';
import {box_of, brakes_of, make_picture, margins_of, scales_of} from '../../examples/explorer/page/picture.js';
import {draw_stage} from '../../examples/explorer/page/stage.js';
import {moment_sentence, newton, questions, still_sentence} from '../../examples/explorer/page/story.js';
import {make_tracks} from '../../examples/explorer/page/tracks.js';
import {dot, length_of, minus, plus, unit} from '../../examples/explorer/page/vectors.js';

const engine = await load(process.argv[2]);
let failures = 0,
  checks = 0,
  seed = 1;

function expect(is_met, what, found = '') {
  ++checks;
  if (!is_met && ++failures <= 20) console.log('failed: ' + what + ' ' + JSON.stringify(found));
}

// From -1 to 1, the same numbers in each run.
function random() {
  seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
  return seed / 2 ** 31 - 1;
}
const numbers = (count, draw = random) => Array.from({length: count}, draw).join();
const {mechanisms} = engine.catalogue,
  planar = mechanisms.filter(mechanism => mechanism.dimension === 2);
const theme = new Proxy({}, {get: (_, name) => (name === 'laws' ? ['a', 'b', 'c'] : String(name))});

// A device of the mechanism in the state of these lines, near the pose at which it begins.
function device_of(info, lines = '') {
  const device = engine.device('mechanism=' + info.id + '\n' + lines),
    {q} = device.state();
  q.forEach((angle, i) => {
    q[i] = angle + 0.25 * random();
  });
  device.evaluate();
  return device;
}

// What the picture of a device shows in a step, wide or as a phone.
function drawn(question, device, info, tracks) {
  const value = id => tracks?.value(0, id) || device.value(id),
    word = (id, k) => (tracks?.value(0, id) ? tracks.word(0, id, k) : device.word(id, k)),
    [width, height] = random() > 0 ? [1100, 470] : [347, 354];
  const view = {
    device, info, question, tracks, value, word, width, height,
    scales: scales_of(device, info),
    bounds: box_of(device, info, question, [0, 0, 0]),
    layers: new Set(question.layers),
    brakes: brakes_of(device, value, word),
    is_moving: !!tracks, focus: 0, colors: ['a'], lens_memory: {}, yaw: 0, pitch: 0,
  };
  view.margins = margins_of(view);
  const picture = make_picture(view),
    {camera, force_scale} = picture,
    at = camera.point(picture.handle),
    area = (picture.cones.find(cone => cone.is_present)?.points || []).map(f => plus(at, camera.vector(f), force_scale));
  draw_stage({width, height, label() {}, image() {}, path() {}, clip: (_, draw) => draw()}, picture, theme);
  return {view, picture, value, word, area, at};
}

// Pixels by which a point is outside of a polygon about a corner at `at`: 0 inside.
function distance_outside(p, polygon, at) {
  let is_inside = false,
    least = length_of(minus(p, at));
  polygon.forEach((a, k) => {
    const b = polygon[(k + 1) % polygon.length],
      e = minus(b, a),
      u = Math.min(1, Math.max(0, dot(minus(p, a), e) / (dot(e, e) || 1)));
    least = Math.min(least, length_of(minus(p, plus(a, e, u))));
    if (a[1] > p[1] !== b[1] > p[1] && p[0] < a[0] + (e[0] * (p[1] - a[1])) / e[1]) is_inside = !is_inside;
  });
  return is_inside ? 0 : least;
}

function expect_inside(name, {picture, area, at}, device) {
  const arrow = picture.arrows.find(other => other.id === 'made'),
    solid = picture.camera.is_space && picture.cones.find(cone => cone.is_present)?.points;
  for (let k = 0; solid && k < 5; ++k) {
    // In space the area is convex: it goes as far as the force in each direction
    const u = [random(), random(), random()],
      far = Math.max(...solid.map(f => dot(f, u)));
    expect(dot(arrow.vector, u) <= far + 1e-4 * Math.max(...solid.map(length_of)), name + ': the force of the brakes ends in the solid', device.settings());
  }
  if (solid) return;
  expect(!arrow?.head || distance_outside(arrow.head, area, at) < 1, name + ': the force of the brakes ends in the area', device.settings());
}

function random_lines(info, more) {
  return (
    `qd=${numbers(info.joints, () => (random() > -0.8 ? random() : 0))}\n` +
    `brakes.torque_limit=${numbers(info.brakes, () => 10 ** random())}\n` +
    `brakes.present=${numbers(info.brakes, () => (random() > -0.9 ? 1 : 0))}\n` + more
  );
}

// The device files of the catalogue open, and what the page saves is one that opens as the same device.
for (const [name, mechanism, law, left_out] of [
  ['paper', 'tendon_two_link', 'direct_control', ''],
  ['five_bar', 'five_bar', 'velocity_direct_control', '[brakes.model] magnetorheological'],
  ['delta', 'delta', 'on_off_control', '[walls] mesh_surface'],
]) {
  const file = settings_of_file(readFileSync(new URL(`../../examples/catalogue/devices/${name}.toml`, import.meta.url), 'utf8')),
    device = engine.device(file.text);
  expect(device, name + '.toml opens', engine.error());
  const settings = device.settings();
  expect(settings.startsWith(`mechanism=${mechanism}\nlaw=${law}\n`) && [...file.left_out].join() === left_out, name + '.toml', [settings, ...file.left_out]);
  const again = engine.device(settings_of_file(device_file_of(mechanism, law, device.form())).text + '\n' + /^q=.*$/m.exec(settings)[0]);
  expect(again?.settings() === settings, name + '.toml is saved as it is', [settings, again?.settings(), engine.error()]);
}

// Step 3: the curve is the locus of the brake that holds, a length to each side.
for (let pose = 0, poses = 0; poses < 100; ++pose) {
  const info = planar[pose % planar.length];
  if (info.joints !== 2) continue;
  ++poses;
  const device = device_of(info),
    brake = poses % info.brakes,
    points = device.locus(brake, 0.02),
    {q, qd} = device.state(),
    start = [...q];
  const rates = [[1, 0], [0, 1]].map(joint => {
    qd.set(joint);
    device.evaluate();
    return device.value('w')[brake];
  });
  expect(length_of(minus(points[32], device.value('x'))) < 1e-12, 'the curve goes through the handle', info.id);
  for (const [k, point] of points.entries()) {
    const step = length_of(minus(point, points[k - 1] || point));
    expect(k === 0 || Math.abs(step - 0.02 / 32) < 2e-4, `${info.id}: points follow each other`, step);
    const turn = device.reach(point) ? dot(rates, minus(q, start)) / length_of(rates) : 0;
    expect(Math.abs(turn) < 1e-6, `${info.id}: brake ${brake + 1} holds on the curve`, turn);
  }
  device.delete();
}

const step = id => questions.find(question => question.id === id);
for (let k = 0; k < 1000; ++k) {
  const info = k % 5 ? planar[k % planar.length] : mechanisms[(k / 5) % mechanisms.length], // few in space: they take long
    d = info.dimension;

  { // Step 1
    const device = device_of(info, random_lines(info, 'scene=none\nlaw=no_direct_control')),
      found = drawn(step('forces'), device, info),
      text = still_sentence('forces', found.view),
      present = found.picture.cones.find(cone => cone.is_present);
    const named = /passive FME (\d)/.exec(text)?.[1];
    if (named && info.brakes === 2 && info.joints === 2) expect(present?.name === 'FME ' + named, 'step 1: the number of the area', [text, present?.name]);
    device.delete();
  }

  for (const id of ['wanted', 'direct']) { // Steps 2 and 4
    const scale = id === 'direct' ? `Fh=${numbers(d, () => 3 * random())}\nalpha=${Math.abs(random())}\nlaw=direct_control` : `law=${engine.catalogue.laws[Math.floor(k / 7) % 5]}`,
      device = device_of(info, random_lines(info, `scene=none\ndesired=given\nFd=${numbers(d, () => 10 ** random() * random())}\n${scale}`)),
      found = drawn(step(id), device, info),
      {made} = found.picture;
    expect_inside('step ' + step(id).step, found, device);
    const whole = device.value(length_of(device.value('Fh')) && info.joints === d ? 'brake_force' : 'displayed');
    expect(length_of(minus(whole, made)) <= 1e-6 * length_of(whole), `step ${step(id).step}: the area has all of the force`, [device.settings(), whole, made]);
    const text = still_sentence(id, {...found.view, made, max_angle: 1.55});
    if (id === 'wanted') {
      const Fd = device.value('Fd'),
        off = length_of(minus(unit(Fd), unit(made)));
      expect(length_of(made) ? text.includes('display ' + newton(length_of(made))) || text.includes(', and ' + newton(length_of(made))) || text.includes('exactly*: ' + newton(length_of(made))) : !/display/.test(text), 'step 2: the sentence has the size of the arrow', [text, made]);
      expect(!length_of(made) || /exactly/.test(text) === off < 1e-4, 'step 2: the sentence has the direction of the arrow', [text, off]);
    } else if (/pushes|nothing/.test(text)) {
      const arrow = found.picture.arrows.find(other => other.id === 'Fr'),
        part = dot(arrow.vector, unit(device.value('Fd')));
      expect(/\*out\*/.test(text) ? part > 0 : /\*into\*/.test(text) ? part < 0 : Math.abs(part) < 5e-3 * length_of(device.value('Fh')), 'step 4: the sentence has the side of the arrow', [text, part]);
    }
    device.delete();
  }

  { // Step 3
    const lines = 'scene.rate=20\n' + random_lines(info, ''),
      simulation = engine.simulation(`mechanism=${info.id}\nlaw=${engine.catalogue.laws[Math.floor(k / 7) % 5]}\n${lines}`),
      tracks = make_tracks(simulation.layout, ['no_direct_control']),
      device = device_of(info, lines),
      to = device.value('x').map((c, i) => c + (i < d ? 0.05 * random() : 0));
    simulation.step(20 + Math.floor(40 * (1 + random())), to, true);
    tracks.add(0, simulation.rows());
    const state = device.state();
    state.q.set(tracks.value(0, 'q'));
    state.qd.set(tracks.value(0, 'qd'));
    state.Fh.set(tracks.value(0, 'hand_force'));
    device.evaluate();
    const found = drawn(step('why'), device, info, tracks),
      text = moment_sentence(tracks, 0, found.view.brakes, true);
    expect_inside('step 3', found, device);
    const holding = found.view.brakes.flatMap((brake, i) => (brake.state === 'holds' ? [i + 1] : []));
    if (/hold/.test(text) && found.picture.locus?.is_held)
      expect(holding.every(brake => text.includes('brake ' + brake) || text.includes('Brake ' + brake)), 'step 3: the sentence has the brakes that hold', [text, holding]);
    simulation.delete();
    device.delete();
  }
}
expect(short_number(1.11e-14) === '0' && short_number(-20000) === '−2·10⁴' && newton(20000) === '*20 kN*', 'numbers as a reader sees them');
console.log(`steps: ${checks} checks, ${failures} failed`);
process.exit(failures ? 1 : 0);
