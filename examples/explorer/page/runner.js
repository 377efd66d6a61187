// The simulation as the page sees it: a worker beside the page, made from a text, as a page from a file has
// no other.

import {make_tracks} from './tracks.js';

// code, bytes: the engine; worker_code: the text of the worker. events: {started(), came() with new rows, refused(reason),
// log(text)}.
export function make_runner(code, bytes, worker_code, events) {
  const worker = new Worker(URL.createObjectURL(new Blob([worker_code], {type: 'text/javascript'})));
  let run = 0;
  const runner = {
    tracks: null,
    last: null,
    // Simulates devices of these settings, one for each law, from a place of the pointer [m] on; so many cycles at once.
    start(settings, laws, point, ahead) {
      runner.tracks = runner.last = null;
      runner.laws = laws;
      worker.postMessage({kind: 'start', settings, run: ++run, point, ahead});
    },
    // Begins the way of the hand again, and keeps the figures of the last one.
    again() {
      runner.last = runner.tracks?.figures;
      worker.postMessage({kind: 'restart', run: ++run});
    },
    // Begins the record of a motion, from the start of the devices on, or ends it.
    record(is_on) {
      worker.postMessage({kind: 'record', is_on, run: is_on ? ++run : run});
    },
    send: message => worker.postMessage(message),
  };

  worker.onmessage = ({data}) => {
    if (data.run !== undefined && data.run !== run) return;
    if (data.kind === 'started') {
      runner.tracks = make_tracks(data.layout, runner.laws);
      events.started();
    } else if (data.kind === 'rows') {
      data.chunks.forEach((chunk, law) => {
        runner.tracks.add(law, chunk.rows);
        runner.tracks.figures[law] = chunk.figures;
      });
      events.came();
    } else events[data.kind]?.(data);
  };
  worker.postMessage({kind: 'load', code, bytes});
  return runner;
}
