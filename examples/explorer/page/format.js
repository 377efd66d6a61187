// Numbers as a reader sees them. The value itself, with all its digits, stays beside in what is copied.

export function short_number(value, digits = 3) {
  if (Number.isNaN(value)) return '–';
  if (!Number.isFinite(value)) return value > 0 ? '∞' : '−∞';
  if (value === 0) return '0';
  const size = Math.abs(value);
  const text =
    size >= 1e5 || size < 1e-3
      ? value.toExponential(digits - 1).replace('e', 'e')
      : String(Number(value.toPrecision(digits)));
  return text.replace('-', '−');
}

export const degrees = angle => (angle * 180) / Math.PI;

// "F_d" with its subscript for the page. A name of more letters, such as direct_control, has none.
export function symbol_nodes(symbol) {
  return symbol
    .split(/(_\{[^}]*\}|(?<=(?:^|[^A-Za-z_])[A-Za-zα-ω])_[A-Za-z0-9]+)/)
    .filter(part => part)
    .map(part => {
      if (!part.startsWith('_')) return document.createTextNode(part);
      const sub = document.createElement('sub');
      sub.textContent = part.replace(/[_{}]/g, '');
      return sub;
    });
}

// An element with text, or with children.
export function element(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (key === 'text') made.textContent = value;
    else if (key.startsWith('on')) made.addEventListener(key.slice(2), value);
    else if (value === true) made.setAttribute(key, '');
    else if (value !== false && value !== undefined && value !== null) made.setAttribute(key, value);
  }
  made.append(...children);
  return made;
}

// A sentence in which *words* are strong, and F_d has its subscript.
export function set_sentence(target, sentence) {
  if (target.dataset.sentence === sentence) return;
  target.dataset.sentence = sentence;
  target.replaceChildren(
    ...sentence
      .split(/(\*[^*]+\*)/)
      .filter(part => part)
      .flatMap(part =>
        part.startsWith('*') ? [element('b', {}, ...symbol_nodes(part.slice(1, -1)))] : symbol_nodes(part),
      ),
  );
}

// A title as a sentence.
export const ended = title => (/[.?!]$/.test(title) ? title : title + '.');
