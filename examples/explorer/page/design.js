// The design map under the mechanism: computed a few rows at a time, painted in colours that grow darker
// evenly.

import {short_number} from './format.js';

// Stops of viridis, from low to high.
const ramp = [
  [68, 1, 84],
  [72, 40, 120],
  [62, 74, 137],
  [49, 104, 142],
  [38, 130, 142],
  [31, 158, 137],
  [53, 183, 121],
  [110, 206, 88],
  [181, 222, 43],
  [253, 231, 37],
];
const none_color = [176, 176, 176]; // of places where the brakes make no force against the wall
const columns = 72;

function ramp_color(part) {
  const at = Math.min(0.9999, Math.max(0, part)) * (ramp.length - 1),
    k = Math.floor(at);
  return ramp[k].map((c, i) => Math.round(c + (at - k) * (ramp[k + 1][i] - c)));
}

// changed(): more of the map is done.
export function make_design_map(changed) {
  let map = null,
    timer = 0,
    box = null,
    rows = 0,
    done = 0;
  const design = {
    // Begins anew for a device inside a box [m].
    begin(device, bounds) {
      design.end();
      box = {low: [bounds[0], bounds[1]], high: [bounds[3], bounds[4]]};
      rows = Math.max(8, Math.round((columns * (box.high[1] - box.low[1])) / (box.high[0] - box.low[0])));
      map = device.new_map(columns, rows, box.low, box.high);
      done = 0;
      if (map) timer = setTimeout(more, 0);
      return !!map;
    },
    end() {
      clearTimeout(timer);
      map?.end();
      map = null;
    },
    // The picture of a figure of the catalogue: {image, low, high, ramp, texts, title, numbers}.
    picture(index, figure, class_index) {
      if (!map) return null;
      const numbers = map.figure(index),
        known = [...numbers].filter(Number.isFinite).sort((a, b) => a - b);
      // Shares go from 0 to 1; others as far as nearly all places go.
      const is_share = figure.id === 'cosine' || figure.id === 'isotropy';
      const least = is_share ? 0 : known.length ? known[Math.floor(0.02 * known.length)] : 0,
        most = is_share ? 1 : known.length ? known[Math.floor(0.98 * (known.length - 1))] : 1;
      const image = document.createElement('canvas'),
        context = image.getContext('2d');
      image.width = columns;
      image.height = rows;
      const data = context.createImageData(columns, rows),
        classes = map.figure(class_index);
      for (let row = 0; row < rows; ++row)
        for (let column = 0; column < columns; ++column) {
          const value = numbers[row * columns + column],
            at = 4 * ((rows - 1 - row) * columns + column);
          if (!Number.isFinite(value)) continue;
          const color =
            classes[row * columns + column] === 0 && figure.id === 'cosine'
              ? none_color
              : ramp_color(most > least ? (value - least) / (most - least) : 0.5);
          data.data.set([...color, 255], at);
        }
      context.putImageData(data, 0, 0);
      const unit = figure.unit && figure.unit !== '1' ? ' ' + figure.unit : '';
      return {
        image,
        low: box.low,
        high: box.high,
        ramp: ramp.map(c => 'rgb(' + c + ')'),
        title:
          figure.id === 'cosine'
            ? 'force out of the wall, cos γ'
            : figure.label + (figure.symbol ? ' ' + figure.symbol : ''),
        classes: [...classes].filter(Number.isFinite),
        none: figure.id === 'cosine' && `rgb(${none_color})`,
        done: done / rows,
        texts:
          figure.id === 'cosine'
            ? ['hardly', 'exactly']
            : [short_number(least, 2) + unit, short_number(most, 2) + unit],
        known,
      };
    },
  };

  function more() {
    done = map.advance(2);
    changed();
    if (done < rows) timer = setTimeout(more, 0);
  }
  return design;
}
