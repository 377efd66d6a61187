// The engine: the library's headers, compiled to WebAssembly, as objects of the page. Every law, every
// kinematics and every constant is in there. Its functions are described in engine/exports.hpp.

// code: the text that defines explorer_engine; bytes: the WebAssembly.
export async function load_engine(code, bytes) {
  const make = new Function(code + '\n;return explorer_engine;')();
  const silent = () => {};
  return wrap_engine(await make({wasmBinary: bytes, print: silent, printErr: silent, noExitRuntime: true}));
}

// The bytes of a text in base64, unpacked where gzip packed them.
export async function bytes_of(text) {
  const raw = atob(text.replace(/\s+/g, '')),
    bytes = Uint8Array.from(raw, letter => letter.charCodeAt(0));
  if (bytes[0] !== 0x1f || bytes[1] !== 0x8b) return bytes;
  const unpacked = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Uint8Array(await new Response(unpacked).arrayBuffer());
}

function wrap_engine(wasm) {
  const decoder = new TextDecoder(),
    encoder = new TextEncoder();
  const text_at = address => {
    let end = address;
    while (wasm.HEAPU8[end]) ++end;
    return decoder.decode(wasm.HEAPU8.subarray(address, end));
  };
  // Calls with a text that the engine reads during the call.
  const with_text = (text, call) => {
    const encoded = encoder.encode(text),
      address = wasm._malloc(encoded.length + 1);
    wasm.HEAPU8.set(encoded, address);
    wasm.HEAPU8[address + encoded.length] = 0;
    try {
      return call(address);
    } finally {
      wasm._free(address);
    }
  };
  const numbers_at = (address, count) => wasm.HEAPF64.subarray(address >> 3, (address >> 3) + count);
  const error = () => text_at(wasm._explorer_error());

  function make_device(settings) {
    const handle = with_text(settings, text => wasm._explorer_new(text));
    if (!handle) return null;
    const layout = JSON.parse(text_at(wasm._explorer_layout(handle))).values;
    const entries = new Map(layout.map(entry => [entry.id, entry]));
    const points_of = count => {
      const numbers = numbers_at(wasm._explorer_points(handle), 3 * count);
      return Array.from({length: count}, (_, k) => [numbers[3 * k], numbers[3 * k + 1], numbers[3 * k + 2]]);
    };
    return {
      layout,
      set: text => with_text(text, lines => wasm._explorer_set(handle, lines)) !== 0,
      settings: () => text_at(wasm._explorer_settings(handle)),
      form: () => JSON.parse(text_at(wasm._explorer_form(handle))),
      // Parts of the state that the page may write: the numbers of q, qd, Fh and Fd.
      state(joints) {
        const numbers = numbers_at(wasm._explorer_state(handle), 2 * joints + 6);
        return {
          q: numbers.subarray(0, joints),
          qd: numbers.subarray(joints, 2 * joints),
          Fh: numbers.subarray(2 * joints, 2 * joints + 3),
          Fd: numbers.subarray(2 * joints + 3, 2 * joints + 6),
        };
      },
      reach: p => wasm._explorer_reach(handle, p[0], p[1], p[2]) !== 0,
      move: v => wasm._explorer_move(handle, v[0], v[1], v[2]),
      flip: () => wasm._explorer_flip(handle) !== 0,
      evaluate: () => wasm._explorer_evaluate(handle),
      // The numbers of a value of the last evaluate(), copied.
      value(id) {
        const entry = entries.get(id);
        return entry ? [...numbers_at(wasm._explorer_values(handle) + 8 * entry.offset, entry.size)] : [];
      },
      // The name of a value that is one of an enumeration.
      word(id, k = 0) {
        const entry = entries.get(id);
        return entry && entry.words ? entry.words[this.value(id)[k]] || '' : '';
      },
      drawing() {
        const count = wasm._explorer_drawing_count(handle);
        return {count, numbers: numbers_at(wasm._explorer_drawing(handle), 10 * count).slice()};
      },
      bounds: () => [...numbers_at(wasm._explorer_bounds(handle), 6)],
      outline: region => points_of(wasm._explorer_outline(handle, region)),
      locus: (brake, length) => points_of(wasm._explorer_locus(handle, brake, length)),
      walls: (low, high) => points_of(wasm._explorer_walls(handle, low[0], low[1], high[0], high[1])),
      new_map(columns, rows, low, high) {
        const map = wasm._map_new(handle, columns, rows, low[0], low[1], high[0], high[1]);
        return (
          map && {
            advance: count => wasm._map_advance(map, count),
            figure: index => numbers_at(wasm._map_figure(map, index), columns * rows).slice(),
            end: () => wasm._map_delete(map),
          }
        );
      },
      end: () => wasm._explorer_delete(handle),
    };
  }

  function make_simulation(settings) {
    const handle = with_text(settings, text => wasm._sim_new(text));
    if (!handle) return null;
    const layout = JSON.parse(text_at(wasm._sim_layout(handle))),
      ring = 4096;
    return {
      layout,
      set: text => with_text(text, lines => wasm._sim_set(handle, lines)) !== 0,
      step: (cycles, p, is_held) => wasm._sim_step(handle, cycles, p[0], p[1], p[2], is_held ? 1 : 0),
      restart: () => wasm._sim_restart(handle),
      cycles: () => wasm._sim_cycles(handle),
      // The rows of the cycles from first to the last, copied into one array.
      rows_from(first) {
        const cycles = wasm._sim_cycles(handle),
          row = layout.row;
        const from = Math.max(first, cycles - ring, 0),
          rows = new Float64Array(Math.max(0, cycles - from) * row);
        const start = wasm._sim_ring(handle);
        for (let k = from; k < cycles; ++k) rows.set(numbers_at(start + 8 * row * (k % ring), row), (k - from) * row);
        return {first: from, rows};
      },
      figures: () => [...numbers_at(wasm._sim_figures(handle), 2)],
      record: is_on => wasm._sim_record(handle, is_on ? 1 : 0),
      log: () => text_at(wasm._sim_log(handle)),
      end: () => wasm._sim_delete(handle),
    };
  }

  function open_log(settings, log_text) {
    const handle = with_text(settings, lines => with_text(log_text, text => wasm._log_open(lines, text)));
    if (!handle) return null;
    const layout = JSON.parse(text_at(wasm._log_layout(handle)));
    return {
      layout,
      count: () => wasm._log_count(handle),
      row: line => numbers_at(wasm._log_row(handle, line), layout.row).slice(),
      agreement: () => [...numbers_at(wasm._log_agreement(handle), 2)],
      end: () => wasm._log_delete(handle),
    };
  }

  return {
    catalogue: JSON.parse(text_at(wasm._explorer_catalogue())),
    error,
    device: make_device,
    simulation: make_simulation,
    open_log,
  };
}
