// What lies around the device: the design map, a floor in space, a bar of a round length.

import {line_path} from './pen.js';
import {plus} from './vectors.js';

// The design map, painted under the mechanism, and what its colours mean.
export function draw_map(pen, picture, theme) {
  const {map, camera} = picture,
    z = picture.handle ? picture.handle[2] : 0,
    corner = (x, y) => camera.point([x, y, z]);
  const [[x0, y0], [x1, y1]] = [map.low, map.high];
  pen.image(map.image, corner(x0, y1), corner(x1, y1), corner(x0, y0), 0.85);
  const width = 150,
    x = pen.width - width - 18,
    y = pen.height - 30;
  map.ramp.forEach((color, k) =>
    pen.path(
      `M${x + (width * k) / map.ramp.length} ${y}h${width / map.ramp.length + 0.5}v9h${-width / map.ramp.length - 0.5}Z`,
      {fill: color},
    ),
  );
  const text = (label, at, line, align, color = theme.muted) =>
    pen.label(label, at, y + line, {size: 12, align, color, halo: theme.paper});
  text('hardly', x, 23);
  text('exactly', x + width, 23, 'end');
  text('force out of the wall, cos γ', x + width, -7, 'end', theme.ink);
  pen.path(`M${x - 30} ${y}h16v9h-16Z`, {fill: map.none, stroke: theme.muted, width: 0.8});
  text('none', x - 22, 23, 'middle');
}

// A grid on the floor of the space that the device reaches, so that turning it is seen.
export function draw_floor(pen, {bounds, camera, handle}, theme) {
  const [x0, y0, z, x1, y1] = bounds,
    line = (a, b) => line_path(camera.point([...a, z]), camera.point([...b, z])),
    lines = [],
    count = 6;
  for (let k = 0; k <= count; ++k) {
    const x = x0 + ((x1 - x0) * k) / count,
      y = y0 + ((y1 - y0) * k) / count;
    lines.push(line([x, y0], [x, y1]), line([x0, y], [x1, y]));
  }
  pen.path(lines.join(''), {stroke: theme.faint, width: 0.7, alpha: 0.7});
  const from = [42, pen.height - 64],
    style = {size: 13, math: true, align: 'middle', color: theme.muted};
  ['x', 'y', 'z'].forEach((name, i) => {
    const d = camera.vector([0, 1, 2].map(k => (k === i ? 26 : 0))),
      [x, y] = plus(from, d, 1.35);
    pen.path(line_path(from, plus(from, d)), {stroke: theme.muted, width: 1.4});
    pen.label(name, x, y + 4, style);
  });
  if (!handle) return;
  const foot = camera.point([handle[0], handle[1], z]);
  pen.path(line_path(camera.point(handle), foot), {stroke: theme.muted, width: 1, dash: [2, 4]});
}

// A bar of a round length.
export function draw_scale(pen, camera, theme) {
  const length =
    [0.01, 0.1, 1, 10, 100, 1000].flatMap(l => [l, 2 * l, 5 * l]).findLast(l => l * camera.scale < 0.22 * pen.width) ||
    0.01;
  const x = 18,
    y = pen.height - 18,
    end = x + length * camera.scale;
  pen.path(`M${x} ${y - 4}V${y}H${end}V${y - 4}`, {stroke: theme.muted, width: 1.4, cap: 'butt'});
  const style = {size: 12, align: 'middle', color: theme.muted};
  pen.label(length < 1 ? 100 * length + ' cm' : length + ' m', (x + end) / 2, y - 5, style);
}
