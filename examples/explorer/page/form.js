// The form of a device: a field for each setting that the engine names, with its unit and what the engine expects.

const elsewhere = new Set(['q', 'qd', 'Fh', 'Fd', 'alpha', 'desired', 'hand', 'law']); // what the picture and the other controls set
const is_flags = entry => /^1 or 0 for each/.test(entry.expected);

// changed(name, text): a field has a new value.
export function make_form(form, changed) {
  let shown = '',
    entries = new Map();

  const words = text => text.replaceAll('_', ' ');
  function field_of(entry) {
    const {name, label, expected, size, unit, choices} = entry;
    if (is_flags(entry)) {
      const boxes = [...Array(size).keys()].map(
        k => `<label><input type="checkbox" name="${name}.${k}" data-entry="${name}">brake ${k + 1}</label>`,
      );
      return `<div class="flags">${boxes.join('')}</div>`;
    }
    const common = `name="${name}" data-entry="${name}" title="${expected ? 'expected: ' + expected.replace(/</g, '&lt;') : ''}" autocomplete="off"`;
    const options = choices.map(choice => `<option value="${choice}">${words(choice)}</option>`).join('');
    const input = choices.length
      ? `<select ${common}>${options}</select>`
      : `<input ${common} type="text" spellcheck="false">`;
    return `<label class="field"><span>${words(label)}</span>${input}<span class="unit">${(unit || '').replace('^2', '²')}</span></label>`;
  }

  function show_value(entry) {
    if (is_flags(entry))
      return entry.value.split(',').forEach((flag, k) => {
        form.elements.namedItem(entry.name + '.' + k).checked = Number(flag) > 0;
      });
    const field = form.elements.namedItem(entry.name);
    if (!field || (field === document.activeElement && field.value !== '' && field.dataset.typed)) return;
    field.value = entry.value;
    field.classList.toggle('changed', entry.value !== entry.default);
  }

  form.addEventListener('input', ({target}) => {
    target.dataset.typed = '1';
  });
  form.addEventListener('change', ({target}) => {
    const name = target.dataset.entry;
    delete target.dataset.typed;
    const flags = [...form.querySelectorAll(`[data-entry="${name}"]`)].map(box => (box.checked ? '1' : '0')).join();
    changed(name, target.type === 'checkbox' ? flags : target.value.trim());
  });
  return {
    // all: the form of a device; groups: those to show, in this order.
    show(all, groups) {
      entries = new Map(all.filter(entry => !elsewhere.has(entry.name)).map(entry => [entry.name, entry]));
      const key = [...entries.values()].map(entry => entry.name + entry.size).join();
      if (key !== shown)
        form.innerHTML = groups
          .map(([group, title]) => [title, [...entries.values()].filter(entry => entry.group === group)])
          .filter(([, fields]) => fields.length)
          .map(([title, fields]) => `<fieldset><legend>${title}</legend>${fields.map(field_of).join('')}</fieldset>`)
          .join('');
      shown = key;
      entries.forEach(show_value);
    },
  };
}
