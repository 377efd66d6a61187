// The table of numbers: symbol, value, unit and equation of each value that the engine names. Rows are made once for a
// layout; afterwards only texts change.

import {element, short_number, symbol_html} from './format.js';

const group_names = {
  motion: 'Motion',
  forces: 'Forces',
  brakes: 'Brakes',
  decision: 'Decision of the law',
  simulation: 'Simulation',
};

// panel, copy_button: elements. copied(text): is called after a text went to the clipboard.
export function make_numbers(panel, copy_button, copied) {
  let shown = null,
    cells = [];

  function build(layout) {
    const row = ({id, label, symbol, size, columns, unit, equation}) => {
      const numbers = [...Array(size).keys()].map(
        k =>
          (k && columns > 1 && k % columns === 0 ? '<br>' : '') +
          `<span class="number" data-id="${id}" data-index="${k}"></span> `,
      );
      const head = symbol ? `<th scope="row">${symbol_html(symbol)}</th>` : '<td></td>';
      return `<tr>${head}<td><span class="label">${label}</span>${numbers.join('')}${unit && unit !== '1' ? `<span class="unit">${unit}</span>` : ''}</td><td class="eq">${equation && `(${equation})`}</td></tr>`;
    };
    const groups = [...new Set(layout.map(entry => entry.group))].map(group => {
      const rows = layout.filter(entry => entry.group === group).map(row);
      return `<h3>${group_names[group] || group}</h3><table><tbody>${rows.join('')}</tbody></table>`;
    });
    shown = layout;
    panel.innerHTML = groups.join('');
    cells = [...panel.querySelectorAll('.number')];
  }

  const copy = (text, name) => copy_text(text).then(() => copied(name));
  copy_button.addEventListener('click', () =>
    copy(cells.map(({dataset}) => `${dataset.id}[${dataset.index}] ${dataset.value}`).join('\n'), 'all numbers'),
  );
  panel.addEventListener('click', event => {
    const number = event.target.closest('.number');
    if (number) copy(number.dataset.value, number.dataset.value);
  });

  // values: the numbers of an entry.
  return function show(layout, values) {
    if (layout !== shown) build(layout);
    const all = new Map(layout.map(entry => [entry.id, {words: entry.words, numbers: values(entry)}]));
    for (const cell of cells) {
      const {words, numbers} = all.get(cell.dataset.id),
        number = numbers[cell.dataset.index],
        exact = Object.is(number, -0) ? '-0' : String(number);
      if (cell.dataset.value === exact) continue;
      cell.dataset.value = exact;
      cell.textContent = words?.[number] ?? short_number(number, 4);
    }
  };
}

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
