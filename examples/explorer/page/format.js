// Numbers as a reader sees them. The value itself, with all its digits, stays beside in what is copied.

export function short_number(value, digits = 3) {
  if (Number.isNaN(value)) return '–';
  if (!Number.isFinite(value)) return value > 0 ? '∞' : '−∞';
  const size = Math.abs(value);
  if (size < min_size) return '0';
  if (size >= 1e-3 && size < 1e4) return String(Number(value.toPrecision(digits))).replace('-', '−');
  const [mantissa, power] = value.toExponential(digits - 1).split('e');
  return (
    (Number(mantissa) + '·10').replace('-', '−') + power.replace(/./g, c => '⁰¹²³⁴⁵⁶⁷⁸⁹'[c] ?? (c === '-' ? '⁻' : ''))
  );
}
const min_size = 1e-9; // smaller numbers are rounding errors

export const degrees = angle => (angle * 180) / Math.PI;

// "F_d" and "F_{d}" with the subscript for the page. A name of more letters, such as direct_control, has none.
export const symbol_html = text =>
  text
    .replace(/&/g, '&amp;')
    .replace(/</g, '&lt;')
    .replace(/_\{([^}]*)\}|(?<=(?:^|[^A-Za-z_])[A-Za-zα-ω])_([A-Za-z0-9]+)/g, (_, a, b) => `<sub>${a ?? b}</sub>`);

// A sentence in which *words* are strong, and F_d has its subscript.
export function set_sentence(target, sentence) {
  if (target.dataset.sentence === sentence) return;
  target.dataset.sentence = sentence;
  target.innerHTML = symbol_html(sentence).replace(/\*([^*]+)\*/g, '<b>$1</b>');
}

// A title as a sentence.
export const ended = title => (/[.?!]$/.test(title) ? title : title + '.');
