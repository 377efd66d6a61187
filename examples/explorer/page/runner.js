// The simulation as the page sees it: a worker beside the page, made from the text of this file, and the last seconds of each law.

const history_length = 1500;  // points of a curve [1]

// code, bytes: the engine; worker_code: the text of the worker. events: {started(), refused(reason), log(text, command), replayed(), ready()}.
export function make_runner(code, bytes, worker_code, events) {
  const address = URL.createObjectURL(new Blob([worker_code], {type: "text/javascript"}));
  const worker = new Worker(address);
  let run = 0, columns = new Map();
  const runner = {
    laws: [], layout: null, rows: [], figures: [], histories: [], is_late: false, load: 0, is_ready: false,
    start(settings, laws, point) {
      runner.laws = laws;
      runner.rows = [];
      worker.postMessage({kind: "start", settings, run: ++run, point});
    },
    send(message) {
      if (message.kind === "restart" || message.kind === "replay") { message.run = ++run; runner.rows = []; }
      worker.postMessage(message);
    },
    // The numbers of a value in the last row of a law.
    value(law, id) {
      const entry = columns.get(id), row = runner.rows[law];
      return entry && row ? [...row.subarray(entry.offset, entry.offset + entry.size)] : null;
    },
    words: id => columns.get(id)?.words || [],
    word(law, id, k = 0) {
      const entry = columns.get(id), value = runner.value(law, id);
      return entry?.words && value ? entry.words[value[k]] || "" : "";
    },
    stop() { worker.terminate(); },
  };

  worker.onmessage = ({data}) => {
    if (data.kind === "ready") { runner.is_ready = true; events.ready?.(); return; }
    if (data.run !== undefined && data.run !== run) return;
    if (data.kind === "started") {
      runner.layout = data.layout;
      columns = new Map(data.layout.values.map(entry => [entry.id, entry]));
      runner.histories = runner.laws.map(() => empty_history());
      runner.figures = [];
      events.started?.();
    } else if (data.kind === "rows") take_rows(data);
    else events[data.kind]?.(data);
  };
  worker.postMessage({kind: "load", code, bytes});
  return runner;

  function take_rows(data) {
    const length = runner.layout.row;
    data.chunks.forEach((chunk, law) => {
      const count = chunk.rows.length / length;
      if (!count) return;
      runner.rows[law] = chunk.rows.subarray((count - 1) * length);
      runner.figures[law] = chunk.figures;
      for (let k = 0; k < count; ++k)
        if ((chunk.first + k) % 4 === 0) add_point(runner.histories[law], chunk.rows.subarray(k * length, (k + 1) * length));
    });
    runner.is_late = data.is_late;
    runner.load = data.busy / Math.max(1, data.cycles);
    events.rows?.();
  }

  function empty_history() {
    return {count: 0, time: new Float64Array(history_length), depth: new Float64Array(history_length), rate: new Float64Array(history_length),
      alpha: new Float64Array(history_length), x: new Float64Array(3 * history_length)};
  }

  function add_point(history, row) {
    const at = history.count++ % history_length, number = (id, k = 0) => row[columns.get(id).offset + k];
    history.time[at] = number("t");
    history.depth[at] = number("depth");
    history.rate[at] = number("w", columns.get("w").size - 1);
    history.alpha[at] = number("alpha");
    for (let i = 0; i < 3; ++i) history.x[3 * at + i] = number("x", i);
  }
}

// Calls take(k) for the points of the last seconds of a history, oldest first; k is an index into its arrays.
export function each_point(history, seconds, take) {
  const last = history.count - 1, oldest = Math.max(0, history.count - history_length);
  if (last < 0) return;
  const end = history.time[last % history_length];
  let first = last;
  while (first > oldest && end - history.time[(first - 1) % history_length] <= seconds) --first;
  for (let k = first; k <= last; ++k) take(k % history_length);
}
