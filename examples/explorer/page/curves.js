// The depth of the last seconds as a cut through the wall, one colour for each law.

import {circle_path, line_path, points_path} from './pen.js';
import {law_name} from './story.js';
import {each_point} from './tracks.js';
import {short_number} from './format.js';

const shown = 5; // [s]

// tracks: with the histories; colors: of the laws.
export function draw_curves(pen, tracks, theme, colors) {
  const is_small = pen.width < 520,
    left = is_small ? 40 : 58,
    right = pen.width - 14,
    top = is_small ? 30 + 16 * colors.length : 26,
    bottom = pen.height - 18;
  let [low, high, start, end] = [0, 2, Infinity, 0];
  for (const history of tracks.histories)
    each_point(history, shown, k => {
      if (Number.isNaN(history.depth[k])) return;
      low = Math.min(low, 1e3 * history.depth[k]);
      high = Math.max(high, 1e3 * history.depth[k]);
      start = Math.min(start, history.time[k]);
      end = Math.max(end, history.time[k]);
    });
  const most = round_up(high),
    least = Math.max(-most, Math.min(-0.4 * most, -round_up(Math.max(0.1, -low)))),
    x_of = t => left + ((right - left) * (t - Math.max(Math.min(start, end), end - shown))) / shown,
    y_of = depth => top + ((bottom - top) * (depth - least)) / (most - least),
    surface = y_of(0),
    text = (label, x, y, align, style) => pen.label(label, x, y, {size: 12, align, color: theme.muted, ...style});
  pen.path(`M${left} ${surface}H${right}V${bottom}H${left}Z`, {fill: theme.wall, alpha: 0.75});
  pen.path(line_path([left, surface], [right, surface]), {stroke: theme.wall_line, width: 2});
  text('free', right - 6, surface - 6, 'end');
  text('in the wall', right - 6, bottom - 6, 'end');
  text('depth in the wall [mm]', left, top - 8);
  for (const depth of [0, most / 2, most]) {
    if (depth)
      pen.path(line_path([left, y_of(depth)], [right, y_of(depth)]), {stroke: theme.faint, width: 0.6, dash: [2, 4]});
    text(short_number(depth), left - 8, y_of(depth) + 4, 'end');
  }
  pen.clip(`M${left} ${top - 3}H${right + 8}V${bottom + 3}H${left}Z`, () =>
    tracks.histories.forEach((history, law) => {
      const points = [];
      each_point(history, shown, k => {
        if (!Number.isNaN(history.depth[k])) points.push([x_of(history.time[k]), y_of(1e3 * history.depth[k])]);
      });
      if (!points.length) return;
      pen.path(points_path(points), {stroke: colors[law], width: 1.8});
      pen.path(circle_path(points.at(-1), 3.5), {fill: colors[law], stroke: theme.paper, width: 1.2});
    }),
  );
  // The names next to each other, on a phone below each other
  let [at, line] = [right, 17];
  for (let law = colors.length - 1; law >= 0 && at > left + 150; --law) {
    const name = law_name(tracks.laws[law]);
    text(name, at, line, 'end', {size: is_small ? 12 : 13, color: colors[law], weight: 600});
    if (is_small) line += 16;
    else at -= name.length * 13 * 0.6 + 18;
  }
}

// The next of 1, 2, 5, 10, ...
function round_up(value) {
  const power = 10 ** Math.floor(Math.log10(value));
  return power * [1, 2, 5, 10].find(step => step * power >= value * 0.999);
}
