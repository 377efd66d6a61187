// The design map under the mechanism: computed a few rows at a time, painted in colours that grow darker
// evenly.

// Stops of viridis, from low to high.
const ramp = [
  ...[[68, 1, 84], [72, 40, 120], [62, 74, 137], [49, 104, 142], [38, 130, 142]], // dark
  ...[[31, 158, 137], [53, 183, 121], [110, 206, 88], [181, 222, 43], [253, 231, 37]],
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
    // Begins again for a device inside a box [m].
    begin(device, bounds) {
      design.end();
      box = {low: bounds.slice(0, 3), high: bounds.slice(3)};
      rows = Math.max(8, Math.round((columns * (box.high[1] - box.low[1])) / (box.high[0] - box.low[0])));
      map = device.new_map(columns, rows, box.low, box.high);
      done = 0;
      if (map) timer = setTimeout(more, 0);
      return !!map;
    },
    end() {
      clearTimeout(timer);
      map?.delete();
      map = null;
    },
    // {image, low, high, ramp, none: colours, classes, done: share of the map}.
    picture() {
      if (!map) return null;
      const [cosines, classes] = [0, 1].map(figure => map.figure(figure)),
        image = document.createElement('canvas'),
        context = image.getContext('2d');
      Object.assign(image, {width: columns, height: rows});
      const data = context.createImageData(columns, rows);
      cosines.forEach((cosine, k) => {
        const at = 4 * ((rows - 1 - Math.floor(k / columns)) * columns + (k % columns));
        if (Number.isFinite(cosine)) data.data.set([...(classes[k] ? ramp_color(cosine) : none_color), 255], at);
      });
      context.putImageData(data, 0, 0);
      return {
        image,
        ...box,
        ramp: ramp.map(c => `rgb(${c})`),
        none: `rgb(${none_color})`,
        classes: classes.filter(Number.isFinite),
        done: done / rows,
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
