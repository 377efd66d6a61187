// The engine in WebAssembly against the native one: all values of all presets, and closed loops of 21 000 cycles.
//
// usage: node engine.mjs FOLDER_OF_THE_ENGINE VALUES
//
// VALUES: the output of explorer_values. Everything is bit-identical, angles agree to 1e-14.
import {readFileSync} from 'node:fs';
import {load} from './load.mjs';
import {row_length} from '../../examples/explorer/page/tracks.js';

const [folder, values_file] = process.argv.slice(2);
const cycles = 21000,
  cycles_of_a_frame = 20,
  frames_of_a_side = 40,
  reach = 0.01; // as in explorer_values.cpp
const engine = await load(folder);
let compared = 0,
  failures = 0;

// Lines "PRESET ID NUMBER NUMBER ..." by their first two words.
const native = new Map();
for (const line of readFileSync(values_file, 'utf8').trim().split('\n')) {
  const [preset, id, ...numbers] = line.trim().split(' ');
  native.set(preset + ' ' + id, numbers.map(text => Number(text.replace('inf', 'Infinity'))));
}

function compare(name, numbers) {
  const expected = native.get(name) || [];
  native.delete(name);
  numbers.forEach((number, i) => {
    ++compared;
    const is_same = Object.is(number, expected[i]) || (/ gamma$/.test(name) && Math.abs(number - expected[i]) <= 1e-14);
    if (!is_same && ++failures <= 20) console.log(`failed: ${name}[${i}]: ${number}, natively ${expected[i]}`);
  });
}

for (const {id, settings} of engine.catalogue.presets) {
  const device = engine.device(settings);
  device.evaluate();
  for (const value of device.layout) compare(`${id} ${value.id}`, device.value(value.id));
  const [x, y, z] = device.value('x'),
    simulation = engine.simulation(settings),
    {layout} = simulation,
    row = row_length(layout),
    gamma = layout.find(value => value.id === 'gamma').offset;
  let hash = 2166136261,
    rows;
  const add = half => {
    hash = Math.imul(hash ^ half, 16777619);
  };
  for (let frame = 0; frame < cycles / cycles_of_a_frame; ++frame) {
    const way = Math.floor(frame / frames_of_a_side) % 2 === 0 ? reach : -reach;
    simulation.step(cycles_of_a_frame, [x + way, y + way / 2, z - way], frame % 100 < 90);
    rows = simulation.rows();
    const halves = new Uint32Array(rows.buffer);
    for (let i = 0; i < rows.length; ++i) {
      if (i % row === gamma) continue;
      const is_nan = Number.isNaN(rows[i]);
      add(is_nan ? 0 : halves[2 * i]);
      add(is_nan ? 0x7ff80000 : halves[2 * i + 1]);
    }
  }
  for (const value of layout)
    compare(`loop:${id} ${value.id}`, [...rows.subarray(rows.length - row + value.offset).subarray(0, value.size)]);
  compare(`loop:${id} hash`, [hash >>> 0]);
  simulation.delete();
  device.delete();
}
for (const name of native.keys()) if (++failures) console.log(`failed: ${name} is only native`);
console.log(`${compared} numbers of ${engine.catalogue.presets.length} presets and their loops, ${failures} differ`);
process.exit(failures || compared < 1000 ? 1 : 0);
