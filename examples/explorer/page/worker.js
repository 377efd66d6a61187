// The worker: the simulated devices, one for each law, at 1 kHz of real time. All get the pointer of one
// hand. Messages in: start, settings, pointer, speed, pause, restart, record, log. Messages out: rows, refused,
// log.

import {load_engine} from './engine.js';

const period = 1; // of a control cycle [ms]
const max_at_once = 60; // cycles computed before the page is served [1]

let engine,
  simulations = [],
  speed = 1,
  is_paused = true,
  due = 0,
  last = 0;
let pointer = {point: [0, 0, 0], is_held: false};

const handlers = {
  async load({code, bytes}) {
    engine = await load_engine(code, bytes);
    postMessage({kind: 'ready'});
    last = performance.now();
    setInterval(turn, 10);
  },
  start({settings, run, point, ahead}) {
    for (const simulation of simulations) simulation?.delete();
    simulations = settings.map(text => engine.simulation(text));
    const failed = simulations.findIndex(simulation => !simulation);
    if (failed >= 0) {
      postMessage({kind: 'refused', run, reason: engine.error()});
      simulations.forEach(simulation => simulation?.delete());
      simulations = [];
    }
    begin_again(run, point);
    if (simulations.length && ahead) advance(ahead);
  },
  settings({text}) {
    for (const simulation of simulations)
      if (!simulation.set(text)) postMessage({kind: 'refused', run: run_number, reason: engine.error()});
  },
  pointer({point, is_held}) {
    pointer = {point, is_held};
  },
  speed({factor}) {
    speed = factor;
    due = 0;
  },
  pause({is_on}) {
    is_paused = is_on;
    last = performance.now();
    due = 0;
  },
  restart({run}) {
    simulations.forEach(simulation => simulation.restart());
    begin_again(run);
  },
  // From the start of the devices on
  record({is_on, run}) {
    if (is_on) handlers.restart({run});
    simulations.forEach(simulation => simulation.record(is_on));
  },
  log({law}) {
    const simulation = simulations[law];
    if (simulation) postMessage({kind: 'log', law, text: simulation.log()});
  },
};

let run_number = 0;

function begin_again(run, point) {
  run_number = run;
  if (point) pointer = {point, is_held: false};
  due = 0;
  last = performance.now();
  if (simulations.length) postMessage({kind: 'started', run, layout: simulations[0].layout});
}

function turn() {
  const now = performance.now();
  const passed = now - last;
  last = now;
  if (is_paused || !simulations.length) return;
  due += (passed * speed) / period;
  const cycles = Math.min(Math.floor(due), max_at_once);
  if (cycles < 1) return;
  due -= cycles;
  if (due > 100 * speed) due = 0; // a slow machine gives up time that it cannot make up for within a tenth of a second
  advance(cycles);
}

function advance(cycles) {
  const chunks = simulations.map(simulation => {
    simulation.step(cycles, pointer.point, pointer.is_held);
    return {rows: simulation.rows(), figures: simulation.figures()};
  });
  postMessage(
    {kind: 'rows', run: run_number, chunks},
    chunks.map(chunk => chunk.rows.buffer),
  );
}

// Each message waits for those before it, the first for the engine.
let served = Promise.resolve();
onmessage = event => {
  served = served.then(() => handlers[event.data.kind](event.data));
};
