// The engine in WebAssembly against the native one: all values of all presets, and closed loops of 21 000
// cycles.
//
// usage: node engine.mjs FOLDER_OF_THE_ENGINE VALUES
//
// VALUES: what explorer_values prints. Everything is equal bit by bit, angles to 1e-14.
import {createRequire} from 'node:module';
import {readFileSync} from 'node:fs';
import {resolve} from 'node:path';
import {native_values, same_value} from './values.mjs';

const [folder, values_file] = process.argv.slice(2);
const cycles = 21000,
  cycles_of_a_frame = 20,
  frames_of_a_side = 40,
  reach = 0.01,
  ring_size = 4096; // as in explorer_values.cpp
const make_engine = createRequire(import.meta.url)(resolve(folder, 'engine.js'));
const wasm = await make_engine({wasmBinary: readFileSync(resolve(folder, 'engine.wasm'))});
const native = native_values(readFileSync(values_file, 'utf8'));
let compared = 0,
  failures = 0;

const text = address => wasm.UTF8ToString(address);
const with_text = (lines, call) => {
  const address = wasm.allocateUTF8(lines);
  try {
    return call(address);
  } finally {
    wasm._free(address);
  }
};
function fail(what) {
  if (++failures <= 20) console.log('failed: ' + what);
}
function compare(name, layout, address) {
  const expected = native.get(name) || new Map();
  for (const {id, offset, size} of layout)
    for (let i = 0; i < size; ++i) {
      const found = wasm.HEAPF64[(address >> 3) + offset + i],
        of_native = (expected.get(id) || [])[i];
      ++compared;
      if (!same_value(id, found, of_native)) fail(`${name} ${id}[${i}]: ${found}, natively ${of_native}`);
    }
}
const wave = frame => {
  const place = frame % (2 * frames_of_a_side);
  return (2 * (place < frames_of_a_side ? place : 2 * frames_of_a_side - place)) / frames_of_a_side - 1;
};

const {presets} = JSON.parse(text(wasm._explorer_catalogue()));
const names = new Set(presets.flatMap(({id}) => [id, 'loop:' + id]));
for (const name of native.keys()) if (!names.has(name)) fail('the catalogue has no preset ' + name);
for (const {id, settings} of presets) {
  const device = with_text(settings, lines => wasm._explorer_new(lines));
  if (!device) {
    fail(`${id}: ${text(wasm._explorer_error())}`);
    continue;
  }
  wasm._explorer_evaluate(device);
  compare(id, JSON.parse(text(wasm._explorer_layout(device))), wasm._explorer_values(device));
  const start = [
    ...wasm.HEAPF64.subarray(wasm._explorer_values(device) >> 3, (wasm._explorer_values(device) >> 3) + 3),
  ];

  const simulation = with_text(settings, lines => wasm._sim_new(lines));
  const {row, values} = JSON.parse(text(wasm._sim_layout(simulation)));
  const is_hashed = new Array(row).fill(true);
  for (const {id: of_value, offset} of values) if (of_value === 'gamma') is_hashed[offset] = false;
  let hash = 2166136261,
    time = 0;
  const add = half => {
    hash = Math.imul(hash ^ half, 16777619);
  };
  for (let frame = 0; frame < cycles / cycles_of_a_frame; ++frame) {
    const way = reach * wave(frame),
      began = performance.now();
    wasm._sim_step(
      simulation,
      cycles_of_a_frame,
      start[0] + way,
      start[1] + way / 2,
      start[2] - way,
      frame % 100 < 90 ? 1 : 0,
    );
    time += performance.now() - began;
    const halves = new Uint32Array(wasm.HEAPF64.buffer),
      ring = wasm._sim_ring(simulation);
    for (let k = 0; k < cycles_of_a_frame; ++k) {
      const first = (ring >> 3) + ((frame * cycles_of_a_frame + k) % ring_size) * row;
      for (let i = 0; i < row; ++i) {
        if (!is_hashed[i]) continue;
        if (Number.isNaN(wasm.HEAPF64[first + i])) {
          add(0);
          add(0x7ff80000);
        } else {
          add(halves[2 * (first + i)]);
          add(halves[2 * (first + i) + 1]);
        }
      }
    }
  }
  compare('loop:' + id, values, wasm._sim_row(simulation));
  const expected = native.get('loop:' + id)?.get('hash')?.[0];
  ++compared;
  if (hash >>> 0 !== expected)
    fail(`loop:${id}: the numbers of ${cycles} cycles have the hash ${hash >>> 0}, natively ${expected}`);
  console.error(`loop:${id}: ${((1e3 * time) / cycles).toFixed(2)} us a cycle`);
  wasm._sim_delete(simulation);
  wasm._explorer_delete(device);
}
if (compared < 1000) fail(`${compared} numbers compared, expected those of all presets`);
console.log(
  `${compared} numbers of ${presets.length} presets and their loops: ${failures === 0 ? 'all equal' : failures + ' differ'}`,
);
process.exit(failures === 0 ? 0 : 1);
