// The table of numbers: symbol, value, unit and equation of each value that the engine names. Rows are made once for a
// layout; afterwards only texts change.

import {short_number, symbol_html} from './format.js';

const group_names = {
  motion: 'Motion',
  forces: 'Forces',
  brakes: 'Brakes',
  decision: 'Decision of the law',
  simulation: 'Simulation',
};

export function make_numbers(panel) {
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
