// The motion of one device for each law, as rows that the engine wrote: the last row, and curves of the
// last seconds. It comes from the simulation or from a log.

const track_length = 750; // points of a curve [1]
const track_step = 8; // rows a point [1]

// layout: of the engine; laws: ids.
export function make_tracks(layout, laws) {
  const columns = new Map(layout.map(entry => [entry.id, entry]));
  const histories = laws.map(() => ({
    count: 0,
    time: new Float64Array(track_length),
    depth: new Float64Array(track_length),
    x: new Float64Array(3 * track_length),
  }));
  const rows = [],
    figures = [],
    counts = laws.map(() => 0);
  let start; // the time of the first row [s]
  const number = (row, id, k = 0) => row[columns.get(id).offset + k];

  function add_point(history, row) {
    const at = history.count++ % track_length;
    history.time[at] = number(row, 't') - (start ??= number(row, 't'));
    history.depth[at] = number(row, 'depth');
    for (let i = 0; i < 3; ++i) history.x[3 * at + i] = number(row, 'x', i);
  }

  return {
    layout,
    laws,
    rows,
    figures,
    histories,
    // Rows of a law, one after the other.
    add(law, numbers) {
      const length = row_length(layout),
        count = numbers.length / length;
      for (let k = 0; k < count; ++k)
        if (counts[law]++ % track_step === 0) add_point(histories[law], numbers.subarray(k * length, (k + 1) * length));
      if (count) rows[law] = numbers.subarray((count - 1) * length);
    },
    // The numbers of a value in the last row of a law; null where there is none.
    value(law, id) {
      const entry = columns.get(id),
        row = rows[law];
      return entry && row ? [...row.subarray(entry.offset, entry.offset + entry.size)] : null;
    },
    word(law, id, k = 0) {
      const numbers = this.value(law, id);
      return numbers && (columns.get(id).words[numbers[k]] || '');
    },
  };
}

// Numbers of a row.
export const row_length = layout => layout.at(-1).offset + layout.at(-1).size;

// Calls take(k) for the points of the last seconds of a history, oldest first; k is an index into its
// arrays.
export function each_point(history, seconds, take) {
  const last = history.count - 1,
    oldest = Math.max(0, history.count - track_length);
  if (last < 0) return;
  const end = history.time[last % track_length];
  let first = last;
  while (first > oldest && end - history.time[(first - 1) % track_length] <= seconds) --first;
  for (let k = first; k <= last; ++k) take(k % track_length);
}
