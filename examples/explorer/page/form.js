// The form of a device: a field for each setting that the engine names, with its unit and what the engine
// expects.

import {element} from './format.js';

const key_step = 1.05; // by which the arrow keys change a number [1]
const elsewhere = new Set(['q', 'qd', 'Fh', 'Fd', 'desired', 'hand', 'law']); // what the picture and the other controls set

// changed(name, text): a field has a new value.
export function make_form(form, changed) {
  let shown = '';
  return {
    // entries: the list of explorer_form(); groups: those to show, in this order.
    show(entries, groups) {
      const fields = entries.filter(entry => !elsewhere.has(entry.name)),
        key = fields.map(entry => entry.name + entry.size).join();
      if (key !== shown)
        form.replaceChildren(
          ...groups.map(group =>
            fieldset_of(
              group,
              fields.filter(entry => entry.group === group[0]),
            ),
          ),
        );
      shown = key;
      for (const entry of fields) show_value(entry);
    },
  };

  function fieldset_of([group, title], entries) {
    return entries.length
      ? element('fieldset', {}, element('legend', {text: title}), ...entries.map(field_of))
      : '';
  }

  function show_value(entry) {
    if (is_flags(entry)) {
      entry.value.split(',').forEach((flag, k) => {
        form.elements.namedItem(entry.name + '.' + k).checked = Number(flag) > 0;
      });
      return;
    }
    const field = form.elements.namedItem(entry.name);
    if (!field || (field === document.activeElement && field.value !== '' && field.dataset.typed)) return;
    if (entry.kind === 'bool') field.checked = entry.value === '1' || entry.value === 'true';
    else field.value = entry.value;
    field.classList.toggle('changed', entry.value !== entry.default);
  }

  function field_of(entry) {
    const label = entry.label.replaceAll('_', ' ');
    if (is_flags(entry)) return flags_of(entry);
    const common = {
      name: entry.name,
      title: entry.expected ? 'expected: ' + entry.expected : '',
      autocomplete: 'off',
    };
    const input =
      entry.kind === 'choice'
        ? element(
            'select',
            common,
            ...(entry.choices || []).map(choice =>
              element('option', {value: choice, text: choice.replaceAll('_', ' ')}),
            ),
          )
        : entry.kind === 'bool'
          ? element('input', {...common, type: 'checkbox'})
          : element('input', {...common, type: 'text', spellcheck: 'false'});
    input.addEventListener('input', () => {
      input.dataset.typed = '1';
    });
    input.addEventListener('change', () => {
      delete input.dataset.typed;
      changed(entry.name, entry.kind === 'bool' ? (input.checked ? '1' : '0') : input.value.trim());
    });
    input.addEventListener('keydown', event => step_number(event, input, entry));
    return element(
      'label',
      {class: 'field'},
      element('span', {text: label}),
      input,
      element('span', {class: 'unit', text: (entry.unit || '').replace('^2', '²')}),
    );
  }

  // One box for each brake.
  function flags_of(entry) {
    const boxes = [...Array(entry.size).keys()].map(k =>
      element('input', {
        type: 'checkbox',
        name: entry.name + '.' + k,
        onchange: () => changed(entry.name, boxes.map(box => (box.checked ? '1' : '0')).join()),
      }),
    );
    return element(
      'div',
      {class: 'flags'},
      ...boxes.map((box, k) => element('label', {}, box, 'brake ' + (k + 1))),
    );
  }

  // The arrow keys make a number larger and smaller.
  function step_number(event, input, entry) {
    const numbers = input.value.split(',').map(Number);
    if (
      !/^Arrow(Up|Down)$/.test(event.key) ||
      entry.kind !== 'number' ||
      numbers.some(number => !Number.isFinite(number))
    )
      return;
    event.preventDefault();
    const factor = event.key === 'ArrowUp' ? key_step : 1 / key_step;
    changed(entry.name, numbers.map(number => Number((number * factor).toPrecision(4))).join());
  }
}

const is_flags = entry => /^1 or 0 for each/.test(entry.expected || '');
