// The curves of the last seconds: depth as a cut through the wall, the rate of a brake, and alpha. One
// colour for each law.

import {line_path} from './pen.js';
import {each_point} from './tracks.js';
import {short_number} from './format.js';

const max_shown = 5; // [s]

// tracks: with the histories; names and colors: of the laws; brakes: their number.
// With is_short only the depth is drawn.
// last: the tracks of the pass before, drawn pale where this pass has not come to yet.
export function draw_curves(pen, tracks, last, theme, names, colors, brakes, is_short) {
  const width = pen.width,
    is_small = width < 520,
    left = is_small ? 40 : 58,
    right = width - 14,
    gap = 30,
    top = is_small ? 30 + 16 * names.length : 26;
  const unit = is_short ? (pen.height - top - 18) / 2.6 : (pen.height - top - 16 - 2 * gap) / 5;
  const panels = [
    {key: 'depth', at: 0, size: 2.6, title: 'depth in the wall [mm]', factor: 1e3, down: true},
    {key: 'rate', at: 2.6, size: 1.2, title: `rate of brake ${brakes}, ω [rad/s]: 0 where it holds`, even: true},
    {key: 'alpha', at: 3.8, size: 1.2, title: 'α, the share of F_{c} that the law keeps', range: [0, 1]},
  ].map((panel, k) => ({...panel, from: top + panel.at * unit + k * gap, height: panel.size * unit}));
  const [start, end] = times_of(tracks),
    last_end = last ? times_of(last)[1] : 0;
  const seconds = last && end < last_end ? Math.min(max_shown, last_end) : max_shown,
    first = Math.max(start, end - seconds);
  const x_of = t => left + ((right - left) * (t - first)) / seconds;
  for (const panel of is_short ? panels.slice(0, 1) : panels)
    draw_panel(pen, panel, tracks, last && end < last_end ? last : null, end, theme, colors, x_of, left, right);
  // The names beside each other, on a phone below each other
  let [at, line] = [right, 17];
  for (let law = names.length - 1; law >= 0; --law) {
    pen.label(names[law], at, line, {size: is_small ? 12 : 13, align: 'end', color: colors[law], weight: 600});
    if (is_small) line += 16;
    else at -= names[law].length * 13 * 0.6 + 18;
    if (at < left + 150) break;
  }
}

// The first and the last time of the curves that are shown [s].
function times_of(tracks) {
  let start = Infinity,
    end = 0;
  for (const history of tracks.histories)
    each_point(history, max_shown, k => {
      start = Math.min(start, history.time[k]);
      end = Math.max(end, history.time[k]);
    });
  return [Math.min(start, end), end];
}

function draw_panel(pen, panel, tracks, last, now, theme, colors, x_of, left, right) {
  const bottom = panel.from + panel.height;
  let low = Infinity,
    high = -Infinity;
  for (const history of [...tracks.histories, ...(last ? last.histories : [])])
    each_point(history, max_shown, k => {
      const value = history[panel.key][k] * (panel.factor || 1);
      if (value === value) {
        low = Math.min(low, value);
        high = Math.max(high, value);
      }
    });
  const top = panel.even ? round_up(Math.max(Math.abs(low), Math.abs(high), 0.5)) : round_up(Math.max(high, 2)),
    bottom_value = panel.even ? -top : Math.max(-top, Math.min(-0.4 * top, -round_up(Math.max(0.1, -low)))),
    [least, most] = panel.range || [bottom_value, top],
    part_of = value => (panel.height * (value - least)) / (most - least),
    y_of = value => (panel.down ? panel.from + part_of(value) : bottom - part_of(value)),
    ticks = panel.range || (panel.even ? [-most, 0, most] : [0, most / 2, most]);
  if (panel.down) {
    const surface = y_of(0);
    pen.path(`M${left} ${surface}H${right}V${bottom}H${left}Z`, {fill: theme.wall, alpha: 0.75});
    pen.path(line_path([left, surface], [right, surface]), {stroke: theme.wall_line, width: 2});
    pen.label('free', right - 6, surface - 6, {size: 12, align: 'end', color: theme.muted});
    pen.label('in the wall', right - 6, bottom - 6, {size: 12, align: 'end', color: theme.muted});
  }
  for (const value of ticks) {
    const y = y_of(value);
    if (!panel.down || value)
      pen.path(line_path([left, y], [right, y]), {stroke: theme.faint, width: 0.6, dash: [2, 4]});
    pen.label(short_number(value), left - 8, y + 4, {size: 12, align: 'end', color: theme.muted});
  }
  pen.label(panel.title, left, panel.from - 8, {size: 12.5, color: theme.muted});
  pen.clip(`M${left} ${panel.from - 3}H${right + 8}V${bottom + 3}H${left}Z`, () => {
    const curve = (history, from) => {
      const pieces = [];
      let piece = null,
        head = null;
      each_point(history, max_shown, k => {
        const value = history[panel.key][k] * (panel.factor || 1);
        if (value !== value || history.time[k] < from) {
          piece = head = null;
          return;
        }
        head = [x_of(history.time[k]), y_of(value)];
        if (!piece) pieces.push((piece = []));
        piece.push(...head);
      });
      return {pieces, head};
    };
    if (last)
      last.histories.forEach((history, law) =>
        pen.curve(curve(history, now).pieces, {stroke: colors[law], width: 1.4, alpha: 0.3}),
      );
    tracks.histories.forEach((history, law) => {
      const {pieces, head} = curve(history, -1);
      pen.curve(pieces, {stroke: colors[law], width: 1.8});
      if (head)
        pen.path(`M${head[0] - 3.5} ${head[1]}a3.5 3.5 0 1 0 7 0a3.5 3.5 0 1 0 -7 0Z`, {
          fill: colors[law],
          stroke: theme.paper,
          width: 1.2,
        });
    });
  });
}

// The next of 1, 2, 5, 10, ...
function round_up(value) {
  const power = 10 ** Math.floor(Math.log10(value));
  return power * [1, 2, 5, 10].find(step => step * power >= value * 0.999);
}
