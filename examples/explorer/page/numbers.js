// The table of numbers: symbol, value, unit and equation of each value that the engine names. Rows are made
// once for a layout; afterwards only texts change.

import {element, short_number, symbol_nodes} from './format.js';

// panel: the element. copied(text): is called after a number went to the clipboard.
export function make_numbers(panel, copied) {
  let rows = [],
    shown_layout = null;

  function build(layout) {
    shown_layout = layout;
    rows = [];
    const groups = new Map();
    for (const entry of layout) {
      if (!groups.has(entry.group)) groups.set(entry.group, []);
      groups.get(entry.group).push(entry);
    }
    panel.replaceChildren(
      ...[...groups].flatMap(([group, entries]) => {
        const body = element('tbody');
        for (const entry of entries) {
          const cell = element('td'),
            buttons = [];
          cell.append(element('span', {class: 'label', text: entry.label}));
          const columns = Math.max(1, entry.columns || 1);
          for (let k = 0; k < entry.size; ++k) {
            if (k && columns > 1 && k % columns === 0) cell.append(element('br'));
            const button = element('button', {
              type: 'button',
              class: 'number',
              'data-id': entry.id,
              'data-index': k,
            });
            buttons.push(button);
            cell.append(button, ' ');
          }
          if (entry.unit && entry.unit !== '1')
            cell.append(element('span', {class: 'unit', text: entry.unit}));
          body.append(
            element(
              'tr',
              {},
              element(
                ...(entry.symbol ? ['th', {scope: 'row'}] : ['td', {}]),
                ...symbol_nodes(entry.symbol || ''),
              ),
              cell,
              element('td', {
                class: 'eq',
                text: entry.equation ? '(' + entry.equation.replace(/[()]/g, '') + ')' : '',
              }),
            ),
          );
          rows.push({entry, buttons});
        }
        return [element('h3', {text: group_names[group] || group}), element('table', {}, body)];
      }),
    );
  }

  panel.addEventListener('click', event => {
    const button = event.target.closest('.number');
    if (button) copy_text(button.dataset.value).then(() => copied(button.dataset.value));
  });

  // values: the numbers of an entry.
  return function show(layout, values) {
    if (layout !== shown_layout) build(layout);
    for (const {entry, buttons} of rows) {
      const numbers = values(entry);
      for (let k = 0; k < buttons.length; ++k) {
        const word = entry.words ? entry.words[numbers[k]] : undefined;
        const exact = Object.is(numbers[k], -0) ? '-0' : String(numbers[k]);
        if (buttons[k].dataset.value === exact) continue;
        buttons[k].dataset.value = exact;
        buttons[k].textContent = word ?? short_number(numbers[k], 4);
      }
    }
  };
}

const group_names = {
  motion: 'Motion',
  forces: 'Forces',
  brakes: 'Brakes',
  decision: 'What the law decides',
  simulation: 'Simulation',
};

// Copies a text, also where the clipboard is closed to a page from a file.
export async function copy_text(text) {
  try {
    await navigator.clipboard.writeText(text);
  } catch {
    const area = element('textarea', {'aria-hidden': 'true'});
    area.value = text;
    area.style.position = 'fixed';
    area.style.opacity = '0';
    document.body.append(area);
    area.select();
    document.execCommand('copy');
    area.remove();
  }
}
