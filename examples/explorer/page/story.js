// The questions of the page, and the sentences that go with what is seen. Numbers in them are the engine's.

import {degrees, short_number} from './format.js';

// is_moving: the simulation runs; laws: those that it starts with; layers: what is drawn at first; preset:
// where it begins.
export const questions = [
  {
    id: 'watch',
    mark: '▶',
    title: 'Watch a hand glide along a wall',
    is_moving: true,
    preset: 'fig9-none',
    laws: ['no_direct_control', 'velocity_direct_control'],
    layers: ['brakes', 'paths'],
    lead: 'One hand, one wall, two control laws. Without a law the hand bounces off the wall again and again. With the right law it glides. Take the handle and feel it.',
  },
  {
    id: 'forces',
    mark: '1',
    title: 'Which forces can it make here?',
    preset: 'fig2',
    layers: ['cone', 'others', 'references', 'v', 'Fh', 'brakes'],
    lead: 'The green area holds every force that the brakes can make at this place, while the handle moves along v. Drag the handle, or the head of v: the area changes.',
  },
  {
    id: 'wanted',
    mark: '2',
    title: 'What becomes of a wanted force?',
    preset: 'fig3-Fd2',
    layers: ['cone', 'Fd', 'made', 'v', 'brakes'],
    lead: 'A wall wants the black force. The brakes make the orange one. Drag the black arrowhead into the green area and out of it.',
  },
  {
    id: 'why',
    mark: '3',
    title: 'Why does it bounce?',
    is_moving: true,
    preset: 'fig9-none',
    laws: ['no_direct_control'],
    speed: '0.1',
    layers: ['cone', 'Fd', 'made', 'Fh', 'v', 'brakes', 'paths'],
    lead: 'Ten times slower: the wall pushes straight out, but the brakes can only push askew. When a brake holds, the handle can only move on a curve, and the curve leads out of the wall.',
  },
  {
    id: 'laws',
    mark: '4',
    title: 'Which law helps?',
    is_moving: true,
    preset: 'fig9-none',
    laws: ['no_direct_control', 'saturated_direct_control', 'velocity_direct_control'],
    layers: ['brakes', 'paths'],
    lead: 'Three devices, one motion of the hand. The law that helps has a flat curve of depth: the hand stays in the wall, and does not leave it.',
  },
  {
    id: 'mine',
    mark: '5',
    title: 'Would my device do?',
    preset: 'wall',
    layers: ['map', 'brakes'],
    opens_form: true,
    lead: 'Change lengths, brakes and limits in the form: the colours show where your device renders the wall well. The link of this page then carries your device.',
  },
];

// The question under which a preset is shown, by what its settings hold.
export function question_of(settings) {
  const has = name => settings.has(name),
    named = id => questions.find(question => question.id === id);
  if (has('brakes.present')) return named('mine');
  if (settings.get('hand') === 'along')
    return named(settings.get('law') === 'no_direct_control' ? 'why' : 'laws');
  if (has('Fd') || has('Fh')) return named('wanted');
  return named(has('qd') || settings.get('scene') === 'none' ? 'forces' : 'laws');
}

export const layers = [
  {id: 'cone', label: 'forces that can be made now', style: 'cone'},
  {id: 'others', label: 'for other directions', style: 'others'},
  {id: 'references', label: 'reference forces R', style: 'references'},
  {id: 'Fd', label: 'wanted force F_{d}', style: 'Fd'},
  {id: 'made', label: 'made force', style: 'Fc_scaled'},
  {id: 'v', label: 'velocity v', style: 'v'},
  {id: 'Fh', label: 'hand force F_{h}', style: 'Fh'},
  {id: 'Fr', label: 'hand and brakes F_{r}', style: 'Fr'},
  {id: 'brakes', label: 'brakes in words', style: ''},
  {id: 'paths', label: 'paths of the hands', style: ''},
  {id: 'map', label: 'design map', style: ''},
];

const newton = value => '*' + short_number(value, 3) + ' N*';
const length_of = vector => Math.hypot(...vector);

// What the present state means, for the questions without motion. value(id), word(id): of the engine.
// max_angle: of the approximation [rad].
export function still_sentence(question, value, word, brakes, max_angle) {
  const moving = length_of(value('v')) > 0,
    states = brakes.map((brake, k) => 'brake ' + (k + 1) + ' ' + brake.state);
  if (question === 'forces') {
    if (has_no_brake(value, brakes)) return no_brake_text;
    if (!moving && length_of(value('Fh')) === 0)
      return 'Nothing moves and nobody pushes: a brake at rest then makes no force. Drag the head of *v*, or of the hand force *F_h*.';
    return (
      'The brakes can make *every force in the green area*, and none outside of it. Each of them resists the motion: brakes never push. ' +
      list(states, true) +
      '.'
    );
  }
  return question === 'wanted' ? displayed_sentence(value, word, brakes, max_angle) : '';
}

// What the device displays of F_d, within the torque limits.
function displayed_sentence(value, word, brakes, max_angle) {
  const Fd = value('Fd'),
    F = value('displayed'),
    desired = length_of(Fd),
    displayed = length_of(F);
  if (word('status') !== 'ok') return 'The brakes are released: ' + word('status') + '.';
  if (desired === 0)
    return 'No force is wanted here. Drag the black arrowhead, or move the handle into a wall.';
  if (displayed === 0) return released_sentence(value, brakes, max_angle);
  const off = angle_between(Fd, F),
    is_nearest = Math.abs(off - value('gamma')[0]) < same_direction,
    limit = limit_text(value, word),
    holding = holding_text(value, brakes),
    size = (holding && 'up to ') + newton(displayed),
    links = value('capacity').some(capacity => capacity > 0)
      ? ''
      : ' The brakes are released: the links themselves hold this force.';
  const rest = (limit && ': ' + limit) + '.' + scale_text(value('alpha')[0]) + holding + links;
  if (off < same_direction && Math.abs(displayed - desired) < same_size * desired)
    return (
      'The device displays F_d *exactly*, ' +
      size +
      (limit || links ? '' : ': it lies in the green area') +
      rest
    );
  if (off < same_direction)
    return (
      'Direction *exact*, ' +
      size +
      (displayed < desired ? ' of the ' : ' instead of ') +
      newton(desired) +
      rest
    );
  return (
    'F_d lies outside the green area. The ' +
    (is_nearest ? 'nearest force that the device can display' : 'displayed force') +
    ' is *' +
    short_number(degrees(off), 3) +
    '° off*' +
    (is_nearest ? ' (γ)' : '') +
    ': what is across F_d is felt as a pull along the wall. The device displays ' +
    size +
    (limit && is_nearest ? ' of the ' + newton(length_of(value('Fc'))) + ' needed' : '') +
    rest
  );
}

const same_direction = 1e-4, // [rad]
  same_size = 1e-6; // [1]

// Stays accurate for small angles.
function angle_between(a, b) {
  const [u, v] = [a, b].map(f => f.map(c => c / length_of(f)));
  return 2 * Math.asin(Math.min(1, length_of(u.map((c, i) => c - v[i])) / 2));
}

// Why nothing is displayed.
function released_sentence(value, brakes, max_angle) {
  if (has_no_brake(value, brakes)) return no_brake_text;
  if (length_of(value('displayed_without_law')) > 0)
    return 'The law releases the brakes here: nothing is felt.';
  return (
    '*No force* of the green area comes within ' +
    short_number(degrees(max_angle), 3) +
    '° of F_d. The brakes are released: nothing is felt.'
  );
}

const no_brake_text = 'No brake has a torque limit above 0: nothing is felt.';
const has_no_brake = (value, brakes) =>
  value('torque_limit').every((limit, k) => limit === 0 || brakes[k].state === 'no brake');

// "both brakes are at their limit"; empty if none is.
function limit_text(value, word) {
  const shares = value('torque_share'),
    names = shares.flatMap((share, k) => (share > 1 - 1e-9 ? ['brake ' + (k + 1)] : []));
  if (!names.length) return word('saturated') === 'yes' ? 'the torque limits are applied before α' : '';
  if (names.length === 1) return names[0] + ' is at its limit';
  return (
    (names.length < shares.length ? list(names) : shares.length === 2 ? 'both brakes' : 'all brakes') +
    ' are at their limit'
  );
}

// A brake at rest only balances the hand.
function holding_text(value, brakes) {
  const capacity = value('capacity'),
    torque = value('torque'),
    is_commanded = value('torque_share').map(share => share > same_size);
  return brakes
    .map((brake, k) =>
      brake.state === 'holds' && is_commanded[k] && Math.abs(torque[k]) < capacity[k]
        ? ` Brake ${k + 1} holds: it gives only as much as the hand pushes, now *${brake.made}*.`
        : '',
    )
    .join('');
}

const scale_text = alpha =>
  alpha < 1
    ? ' The law takes only α = *' + short_number(alpha, 3) + '* of it, so that the hand is not thrown off.'
    : '';

// What happens at this moment of the simulation, in one sentence.
export function moment_sentence(tracks, law, brakes) {
  const depth = tracks.value(law, 'depth')?.[0];
  if (depth === undefined) return '';
  const holding = brakes
    .map((brake, k) => (brake.state === 'holds' ? 'brake ' + (k + 1) : ''))
    .filter(text => text);
  const millimetres = '*' + short_number(Math.abs(1e3 * depth), 2) + ' mm*',
    out = leaving(tracks, law);
  if (!(depth > 0))
    return (
      'The handle is free, ' +
      millimetres +
      ' off the wall. The brakes are released, and the hand presses it back.'
    );
  if (holding.length && out)
    return (
      '*Bounce:* ' +
      list(holding) +
      ' holds, so the handle can only move on a curve. Here the curve leads *out* of the wall, ' +
      millimetres +
      ' deep.'
    );
  if (holding.length)
    return list(holding, true) + ' holds. The handle is ' + millimetres + ' deep and cannot sink further.';
  return (
    'The handle is ' +
    millimetres +
    ' deep in the wall and moves ' +
    (out ? 'out' : 'in') +
    (brakes.some(brake => brake.state === 'slips')
      ? '. The brakes slip: they resist, and nothing is stuck.'
      : '. The brakes are released.')
  );
}

// Whether the handle moves out of the wall: the sign of the last change of depth.
function leaving(tracks, law) {
  const history = tracks.histories[law];
  if (history.count < 3) return false;
  const n = history.depth.length;
  return history.depth[(history.count - 1) % n] < history.depth[(history.count - 3) % n];
}

// last: the figures of the pass before, which count until this pass has gone on for a while.
export function laws_sentence(tracks, last) {
  const is_early = last && !(tracks.figures[0]?.[7] > 1),
    figures = is_early ? last : tracks.figures;
  const known = tracks.laws
    .map((law, k) => ({law, figures: figures[k]}))
    .filter(entry => entry.figures && entry.figures[7] > 0.2);
  if (known.length < 2) return 'The hand comes to the wall.';
  const counts = [...new Set(known.map(entry => entry.figures[0]))].sort((a, b) => a - b);
  const parts = counts.map(
    count =>
      '*' +
      times(count) +
      '* under ' +
      list(known.filter(entry => entry.figures[0] === count).map(entry => '*' + entry.law + '*')),
  );
  return (is_early ? 'On the last way' : 'So far') + ' the hand left the wall ' + list(parts) + '.';
}

const times = count => (count === 0 ? 'never' : count === 1 ? 'once' : short_number(count) + ' times');

function list(parts, is_start = false) {
  const text = parts.length < 2 ? parts.join('') : parts.slice(0, -1).join(', ') + ' and ' + parts.at(-1);
  return is_start ? text.charAt(0).toUpperCase() + text.slice(1) : text;
}

// "1,-0" with numbers as a reader sees them.
const vector_text = text =>
  text
    .split(',')
    .map(x => short_number(Number(x)))
    .join(', ');

// What a design map says. known: the numbers of all places in reach, from the least on; classes: how each
// place displays the wall, with its words; task: {direction, normal} in text.
export function design_sentence(figure, known, classes, words, task) {
  if (!known.length) return 'The map is being computed.';
  const share = test =>
      '*' +
      short_number((100 * classes.filter(place => test(words[place])).length) / classes.length, 2) +
      ' %*',
    unit = figure.unit && figure.unit !== '1' ? ' ' + figure.unit : '';
  if (figure.id === 'cosine')
    return (
      'At ' +
      share(word => word === 'exact' || word === 'approximate') +
      ' of all places the brakes can make a force against a wall with the normal (' +
      vector_text(task.normal) +
      ') while the hand moves along (' +
      vector_text(task.direction) +
      '): yellow is straight against it, dark is hardly. At the others they can make none.'
    );
  return (
    figure.look +
    ' Over all places that it reaches the median is *' +
    short_number(known[known.length >> 1], 3) +
    unit +
    '*, the least *' +
    short_number(known[0], 3) +
    unit +
    '*, the most *' +
    short_number(known.at(-1), 3) +
    unit +
    '*.'
  );
}

// The columns of the table of laws: figure of sim_figures(), factor to the unit that is shown.
export const result_columns = [
  {title: 'left the wall', of: 0, factor: 1, unit: 'times'},
  {title: 'deepest', of: 1, factor: 1e3, unit: 'mm'},
  {title: 'depth, mean', of: 2, factor: 1e3, unit: 'mm'},
  {title: 'unrest of depth', of: 3, factor: 1e3, unit: 'mm'},
  {title: 'a brake sticks', of: 4, factor: 100, unit: '%'},
  {title: 'pull along the wall', of: 5, factor: 1, unit: 'N'},
];
