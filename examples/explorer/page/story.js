// The five steps of the page, the views that follow step 4, and the sentences that say what the picture means.

import {degrees, short_number} from './format.js';
import {dot, length_of, minus, unit} from './vectors.js';

// The paper's device at its wall, the brakes just strong enough for a hand.
const arm = 'mechanism=tendon_two_link\nbrakes.torque_limit=0.129,0.129\nq=1.6352759066114992,-1.108504851001068\n';
const along = 'qd=-0.314448465631,0.275585167518\nlaw=no_direct_control\n';

// id: of the link. step: in the row of steps. drag: the grip of the step. preset or start: the device at first.
// layers: what is drawn. A view that moves has its laws and its speed.
export const questions = [
  {
    id: 'forces',
    step: 1,
    title: 'Brakes only resist',
    short: 'Resist',
    drag: 'v',
    start: arm + along + 'scene=none\n',
    layers: ['cone', 'others', 'references', 'v'],
    lead: 'A brake resists motion, it never pushes. Drag the arrowhead of v: the area of forces that the brakes can produce flips.',
  },
  {
    id: 'wanted',
    step: 2,
    title: 'A wall requires more',
    short: 'Wall',
    drag: 'Fd',
    start: arm + along + 'scene=none\ndesired=given\nFd=0,-2.4\n',
    layers: ['cone', 'Fd', 'made', 'v', 'brakes'],
    lead: 'A virtual wall requires the force F_d, straight out of its surface. Drag its arrowhead: if it leaves the area, the brakes display the nearest force.',
  },
  {
    id: 'why',
    step: 3,
    title: 'Why the hand bounces',
    short: 'Bounce',
    drag: 'handle',
    is_moving: true,
    preset: 'fig9-none',
    laws: ['no_direct_control'],
    speed: 0.1,
    layers: ['cone', 'Fd', 'made', 'locus', 'brakes', 'paths'],
    lead: 'A brake that holds leaves the handle one curve, drawn in blue. The curve leads out of the wall. Ten times slower than real time.',
  },
  {
    id: 'direct',
    step: 4,
    title: 'Direct control',
    short: 'Control',
    drag: 'alpha',
    start: arm + 'qd=-0.3072,0.2536\nlaw=direct_control\ndesired=given\nFd=0,-2.4\nFh=1.4,1.2\nalpha=1\n',
    layers: ['cone', 'made', 'Fh', 'Fr', 'brakes'],
    lead: 'Direct control makes the brakes weaker, by a factor α, until hand and brakes together push along the wall only (Fig. 6).',
  },
  {
    id: 'laws',
    step: 4,
    part: 'paper',
    title: "The hand under the paper's law",
    drag: 'handle',
    is_moving: true,
    preset: 'fig8',
    laws: ['no_direct_control', 'saturated_direct_control', 'velocity_direct_control'],
    layers: ['brakes', 'paths'],
    lead: 'The same hand on several devices, each under its own law: without control it bounces, under direct control it glides.',
  },
  {
    id: 'watch',
    step: 4,
    part: 'recommended',
    title: 'The hand under the recommended law',
    drag: 'handle',
    is_moving: true,
    preset: 'fig9-none',
    laws: ['no_direct_control', 'velocity_direct_control'],
    layers: ['brakes', 'paths'],
    lead: 'The wall is updated only 20 times a second. Without control the hand bounces; under velocity control, which accounts for inertia and brake lag, it glides.',
  },
  {
    id: 'mine',
    step: 5,
    title: 'Would my device do?',
    short: 'Device',
    drag: 'normal',
    preset: 'wall',
    layers: ['map', 'normal'],
    lead: 'Choose a device, set its lengths and brakes under More, and turn the wall by the arrowhead of n: the colours show where the device can render it.',
  },
];

// The views of step 4, in their order, each with the link that opens it.
export const parts = [
  {id: 'direct', title: 'Set α yourself'},
  {id: 'fig8', part: 'paper', title: "The paper's law"},
  {id: 'watch', part: 'recommended', title: 'The recommended law'},
];

const laws = {
  no_direct_control: {
    name: 'no control',
    look: "The brakes make the force nearest to the wall's, as hard as they can: the hand bounces.",
  },
  direct_control: {
    name: 'direct control (as printed)',
    look: 'Where the handle moves out, alpha scales the force so that nothing of the resultant is left normal to the wall. Equation (12).',
  },
  saturated_direct_control: {
    name: 'direct control (the paper)',
    look: "Alpha scales what the brakes can make, as the paper's experiments read it: the brakes let go while the handle moves out. Equation (12).",
  },
  velocity_direct_control: {
    name: 'velocity control (recommended)',
    look: 'The brakes keep the handle at a small depth by the inertia of the device and their own lag: it glides.',
  },
  on_off_control: {
    name: 'on-off control',
    look: 'The whole force or none, by a relay that looks ahead by the lag of the brakes.',
  },
};
export const law_name = id => laws[id].name;
export const law_look = id => laws[id].look;

// The view in which a preset is shown, by its settings.
export function question_of(settings, id = '') {
  const has = name => settings.has(name),
    named = name => questions.find(question => question.id === name);
  if (id === 'fig6') return named('direct');
  if (has('brakes.present')) return named('mine');
  if (settings.get('hand') === 'along') return named(settings.get('law') === 'no_direct_control' ? 'why' : 'laws');
  if (has('Fd') || has('Fh')) return named('wanted');
  return named(has('qd') || settings.get('scene') === 'none' ? 'forces' : 'laws');
}

// The layers with a line in the legend.
export const layers = [
  {id: 'cone', label: 'forces the brakes can produce', mark: 'area', color: 'cone'},
  {id: 'others', label: 'for other motions', mark: 'area', color: 'faint'},
  {id: 'references', label: 'one brake only, R', mark: 'line', color: 'muted'},
  {id: 'Fd', label: 'force that the wall requires, F_{d}', mark: 'line', color: 'wanted'},
  {id: 'made', label: 'force of the brakes', mark: 'line', color: 'made'},
  {id: 'v', label: 'velocity v', mark: 'line', color: 'motion'},
  {id: 'Fh', label: 'force of the hand, F_{h}', mark: 'line', color: 'hand'},
  {id: 'Fr', label: 'resultant of hand and brakes, F_{r}', mark: 'line', color: 'result'},
  {id: 'locus', label: 'curve of the handle while a brake holds', mark: 'curve', color: 'holds'},
  {id: 'normal', label: 'out of the wall, n', mark: 'line', color: 'wanted'},
];

export const newton = value => `*${value >= 1e4 ? short_number(value / 1e3) + ' kN' : short_number(value) + ' N'}*`;

// What a pose means. state: {value(id), word(id, k), brakes, made: the force that is drawn [N], max_angle [rad]}.
export function still_sentence(question, state) {
  if (question === 'forces') return area_sentence(state);
  if (question === 'direct') return scaled_sentence(state);
  return question === 'wanted' ? made_sentence(state) : '';
}

function area_sentence({value, brakes}) {
  const region = value('region')[0],
    name = region >= 0 && value('R_defined')[0] ? `, *passive FME ${region + 1}*,` : '';
  if (has_no_brake(value, brakes)) return no_brake_text;
  return length_of(value('v'))
    ? `The brakes can produce every force in the green area${name} and none outside it, because each torque must oppose the rotation of its brake.`
    : 'Nothing moves. A brake at rest holds against a push from either side, so the area extends to both sides of the handle.';
}

// What the brakes make of F_d within the torque limits.
function made_sentence({value, word, brakes, made, max_angle}) {
  const Fd = value('Fd'),
    [wanted, size] = [Fd, made].map(length_of);
  if (word('status') !== 'ok') return `The brakes are released: ${word('status')}.`;
  if (has_no_brake(value, brakes)) return no_brake_text;
  if (wanted === 0) return 'The handle is free: no force is required here. Drag the arrowhead of F_d.';
  if (size === 0 && length_of(value('displayed')) > 0) return 'The brakes hold, and nobody pushes: *no force* is felt.';
  if (size === 0 && length_of(value('displayed_without_law')) > 0)
    return 'The law releases the brakes here: nothing is felt.';
  if (size === 0)
    return `*No force* in the green area is within ${short_number(degrees(max_angle))}° of F_d. The brakes are released: nothing is felt.`;
  const off = angle_between(Fd, made),
    rest = '.' + alpha_text(value) + limit_text(value, word, brakes);
  if (off < same_direction && Math.abs(size - wanted) < same_size * wanted)
    return `F_d is in the green area. The brakes display it *exactly*: ${newton(size)}${rest}`;
  if (off < same_direction)
    return `The brakes display the direction of F_d *exactly*, and ${newton(size)} of ${newton(wanted)}${rest}`;
  const nearest =
    Math.abs(off - value('gamma')[0]) < same_direction ? ' (γ), the nearest force that they can produce' : '';
  return `F_d is outside the green area. The brakes display ${newton(size)}, *${short_number(degrees(off))}° off*${nearest}. The hand feels the difference as a pull along the wall${rest}`;
}

const same_direction = 1e-4, // [rad]
  same_size = 1e-6; // [1]

// Stays accurate for small angles.
const angle_between = (a, b) => 2 * Math.asin(Math.min(1, length_of(minus(unit(a), unit(b))) / 2));

// The part of the resultant out of the wall, as the sentence of step 4 and its picture use it [N].
const normal_part = value => dot(value('Fr'), unit(value('Fd')));

function scaled_sentence(state) {
  const {value, brakes} = state,
    part = normal_part(value),
    alpha = `α = *${short_number(value('alpha')[0])}*: `,
    holding = list(brakes.flatMap(({state, share}, k) => (state === 'holds' && share > 0 ? ['brake ' + (k + 1)] : [])));
  if (!length_of(value('Fd'))) return made_sentence(state);
  if (Math.abs(part) < 5e-3 * length_of(value('Fh')))
    return alpha + '*nothing* of the resultant F_r is left across the wall. The hand *glides*.';
  if (part > 0)
    return `${alpha}${holding && holding + ' holds, and '}the resultant F_r pushes the handle *out* of the wall with ${newton(part)}: the hand *bounces*. Make α smaller.`;
  return `${alpha}the resultant F_r pushes the handle *into* the wall with ${newton(-part)}: the brakes are too weak, and the hand *sinks in*. Make α larger.`;
}

const no_brake_text = 'No brake has a torque limit above 0: nothing is felt.';
const has_no_brake = (value, brakes) =>
  value('torque_limit').every((limit, k) => limit === 0 || brakes[k].state === 'no brake');

// The brakes at their limit, and those at rest, which only balance the hand.
function limit_text(value, word, brakes) {
  const shares = value('torque_share'),
    is_balancing = k => brakes[k].state === 'holds' && brakes[k].share < shares[k] - same_size,
    names = test =>
      list(
        shares.flatMap((_, k) => (test(k) ? ['brake ' + (k + 1)] : [])),
        true,
      ),
    limited = names(k => shares[k] > 1 - 1e-9 && !is_balancing(k)),
    balancing = names(k => is_balancing(k));
  return (
    (limited ? ` At the torque limit: ${limited}.` : '') +
    (balancing ? ` At rest, with only as much as the hand pushes: ${balancing}.` : '') +
    (!limited && !balancing && word('saturated') === 'yes' ? ' The torque limits are applied before α.' : '')
  ).replace(/: Brake/g, ': brake');
}

const alpha_text = value =>
  value('alpha')[0] < 1 ? ` This is αF_c with α = *${short_number(value('alpha')[0])}*.` : '';

// What happens at this moment of the simulation. is_pushing: the hand pushes into the wall.
export function moment_sentence(tracks, law, brakes, is_pushing) {
  const depth = tracks.value(law, 'depth')?.[0];
  if (depth === undefined) return '';
  const holding = brakes.flatMap((brake, k) => (brake.state === 'holds' ? ['brake ' + (k + 1)] : [])),
    hold = holding.length > 1 ? 'hold' : 'holds',
    deep = `*${short_number(Math.abs(1e3 * depth), 2)} mm*`,
    out = leaving(tracks, law);
  if (!(depth > 0))
    return `The handle is ${deep} off the wall: the brakes are released, and the hand ${is_pushing ? 'pushes it back' : 'keeps it there'}.`;
  if (holding.length && out && !is_pushing) return 'The hand pulls the handle off the wall on purpose: no bounce.';
  if (holding.length && out)
    return `*Bounce:* the hand pushes in, but ${list(holding)} ${hold} and the blue curve leads *out*. The handle is still ${deep} deep.`;
  if (holding.length)
    return `${list(holding, true)} ${hold}: the handle can only move on the blue curve. It is ${deep} deep.`;
  const slips = brakes.some(brake => brake.state === 'slips') ? 'The brakes slip' : 'The brakes are released';
  return `The handle is ${deep} deep and moves ${out ? 'out' : 'in'}. ${slips}: nothing holds it.`;
}

// True if the handle moves out of the wall, by the last change of depth.
function leaving(tracks, law) {
  const history = tracks.histories[law],
    n = history.depth.length;
  return history.count > 2 && history.depth[(history.count - 1) % n] < history.depth[(history.count - 3) % n];
}

// last: the figures of the pass before, which count until this pass has gone on for a while.
export function laws_sentence(tracks, last) {
  const is_early = last && !(tracks.figures[0]?.[1] > 1),
    figures = is_early ? last : tracks.figures;
  const known = tracks.laws.map((law, k) => ({law, figures: figures[k]})).filter(entry => entry.figures?.[1] > 0.2);
  if (known.length < 2) return 'The hand comes to the wall.';
  const counts = [...new Set(known.map(entry => entry.figures[0]))].sort((a, b) => b - a);
  const said = counts.map(
    count =>
      '*' +
      (count === 0 ? 'never' : count === 1 ? 'once' : short_number(count) + ' times') +
      '* under ' +
      list(known.filter(entry => entry.figures[0] === count).map(entry => '*' + law_name(entry.law) + '*')),
  );
  return (is_early ? 'On the last pass' : 'So far') + ' the hand bounced off the wall ' + list(said) + '.';
}

function list(names, is_start = false) {
  const text = names.length < 2 ? names.join('') : names.slice(0, -1).join(', ') + ' and ' + names.at(-1);
  return is_start ? text.charAt(0).toUpperCase() + text.slice(1) : text;
}

// The answer of step 5. classes: how each place in reach displays the wall, with its words; done: share of the map.
export function design_sentence({classes, done}, words) {
  if (done < 1) return `The map is being computed: *${Math.round(100 * done)} %*.`;
  if (!classes.length)
    return '*No:* the device reaches none of the places of the map. Its links differ too much in length, or the chain cannot close.';
  const none = classes.filter(place => !/exact|approximate/.test(words[place])).length,
    share = Math.max(1, Math.round((100 * none) / classes.length)),
    task = 'push out of this wall while the hand slides along it.';
  if (!none) return '*Yes:* everywhere in its reach the brakes can ' + task;
  if (none === classes.length) return `*No:* nowhere in its reach can the brakes ${task} The hand sinks in.`;
  return `*Not everywhere:* at the grey places, *${share} %* of its reach, the brakes cannot ${task} There the hand sinks in.`;
}
