// Device files of the library (docs/guide/device.md) as settings of the page, and back.

const sections = ['mechanism', 'brakes', 'law']; // their keys are settings of the same names
const page_types = {five_bar_with_four_brakes: 'five_bar_4'}; // mechanisms with another name on the page
// The law of a file without one: all mechanisms of the page have inertia.
const usual_law = has_sensor => (has_sensor ? 'velocity_direct_control' : 'on_off_control');

// The tables of a text, {name, keys: Map}, in their order. Throws a text if a line is not understood.
function tables_of(text) {
  const tables = [{name: '', keys: new Map()}];
  let open = '';
  text.split(/\r?\n/).forEach((line, k) => {
    open += line.replace(/^((?:[^"#]|"[^"]*")*)#.*$/, '$1').trim();
    const [, name] = /^\[\[?([\w.]+)\]?\]$/.exec(open) || [],
      [, key, value] = /^(\w+)\s*=\s*(.*)$/.exec(open) || [];
    if (name) tables.push({name, keys: new Map()});
    else if (key && value.split('[').length > value.split(']').length) return; // the list goes on
    else if (key) tables.at(-1).keys.set(key, value_of(value, k + 1));
    else if (open) throw `line ${k + 1}: '${open.slice(0, 80)}': expected [table] or key = value`;
    open = '';
  });
  if (open) throw `last line: '${open.slice(0, 80)}': expected a ] at its end`;
  return tables;
}

function value_of(text, line) {
  try {
    return JSON.parse(text.replace(/,\s*\]/g, ']').replace(/(\d)_(?=\d)/g, '$1'));
  } catch {
    throw `line ${line}: '${text.slice(0, 80)}': expected a number, a text in quotes or a list of numbers`;
  }
}

// The settings of a device file, {text, left_out: a set of what the page cannot show}. Throws a text.
export function settings_of_file(text) {
  const lines = new Map(),
    left_out = new Set();
  let has_wall = false,
    has_sensor = true;
  for (const {name, keys} of tables_of(text)) {
    const type = keys.get('type'),
      scene = name === 'walls' && !has_wall && scene_of(type, keys);
    if (sections.includes(name)) {
      for (const [key, value] of keys)
        if (key !== 'type') lines.set(`${key === 'max_approximation_angle' ? 'options' : name}.${key}`, value);
      if (type) lines.set(name, page_types[type] || type);
    } else if (scene) {
      has_wall = true;
      lines.set('scene', scene);
      if (keys.has('stiffness')) lines.set('scene.stiffness', keys.get('stiffness'));
    } else if (name === 'scene' && keys.get('period') > 0) lines.set('scene.rate', 1 / keys.get('period'));
    else if (name === 'homing' && keys.has('pose')) lines.set('q', keys.get('pose'));
    else if (name === 'sensor') has_sensor = type !== 'none';
    else if (keys.size) left_out.add(`[${name}]` + (type ? ' ' + type : ''));
  }
  if (!lines.has('law')) lines.set('law', usual_law(has_sensor));
  const lag = lines.get('brakes.time_constant');
  if (lag !== undefined && !lines.has('law.lead')) lines.set('law.lead', Math.max(...[lag].flat()));
  return {text: [...lines].map(([name, value]) => `${name}=${value}`).join('\n'), left_out};
}

function scene_of(type, keys) {
  if (type === 'half_space' && keys.has('surface_point') && keys.has('normal'))
    return `plane:${keys.get('surface_point')},${keys.get('normal')}`;
  return type === 'ball' && `${keys.get('inside') || 'solid'}:${keys.get('centre')},${keys.get('radius')}`;
}

// The device file of a device with this form, with which `examples/run replay` replays its log; '' for a mechanism
// or a wall that device files do not have.
export function device_file_of(mechanism, law, form) {
  const value = name => form.find(entry => entry.name === name).value,
    [kind, numbers] = value('scene').split(':'),
    d = value('Fh').split(',').length,
    list = text => (text.includes(',') ? `[${text}]` : text),
    at = (from, to) => list(numbers.split(',').slice(from, to).join()),
    shape = {
      plane: () => `type = "half_space"\nsurface_point = ${at(0, d)}\nnormal = ${at(d)}`,
      solid: () => `type = "ball"\ncentre = ${at(0, d)}\nradius = ${at(d)}\ninside = "${kind}"`,
    }[kind === 'hollow' ? 'solid' : kind];
  if (!shape || /3r$/.test(mechanism)) return '';
  const type = Object.keys(page_types).find(name => page_types[name] === mechanism) || mechanism,
    keys = group =>
      form
        .filter(entry => entry.name.startsWith(group + '.') && entry.name !== 'brakes.present')
        .map(entry => entry.name.split('.')[1] + ' = ' + (entry.choices.length ? `"${entry.value}"` : list(entry.value)))
        .join('\n'),
    present = value('brakes.present').split(','),
    bound = size => `[${present.map(flag => (Number(flag) ? size : 0))}]`,
    off = present.includes('0') ? `\ntorque_lower = ${bound('-inf')}\ntorque_upper = ${bound('inf')}` : '',
    rate = Number(value('scene.rate'));
  return `[mechanism]
type = "${type}"
${keys('mechanism')}

[brakes]
${keys('brakes')}${off}

[law]
type = "${law}"
${keys('law')}
${keys('options')}

[[walls]]
stiffness = ${value('scene.stiffness')}
${shape()}
${rate > 0 ? `\n[scene]\nperiod = ${1 / rate}\n` : ''}`;
}
