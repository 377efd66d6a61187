// The values of presets as the native engine prints them, and what "equal" means for them.

// A Map of presets, each a Map from the id of a value to its numbers. Lines: "PRESET ID NUMBER NUMBER ...",
// numbers in hexadecimal.
export function native_values(text) {
  const presets = new Map();
  for (const line of text.split('\n')) {
    const [preset, id, ...numbers] = line.trim().split(/\s+/);
    if (!id) continue;
    if (!presets.has(preset)) presets.set(preset, new Map());
    presets.get(preset).set(id, numbers.map(read_number));
  }
  return presets;
}

// A number of C's format %a, "-0x1.8p+3", or nan and inf.
export function read_number(text) {
  const match = /^([+-]?)0x([0-9a-f])(?:\.([0-9a-f]*))?p([+-]?\d+)$/i.exec(text);
  if (!match)
    return /nan/i.test(text)
      ? NaN
      : /inf/i.test(text)
        ? text.startsWith('-')
          ? -Infinity
          : Infinity
        : Number(text);
  const digits = match[3] || '',
    mantissa = BigInt('0x' + match[2] + digits);
  // Both factors are exact: 53 bits, and a power of two (in two steps where it is subnormal).
  const power = Number(match[4]) - 4 * digits.length,
    half = Math.trunc(power / 2);
  return (match[1] === '-' ? -1 : 1) * (Number(mantissa) * 2 ** half * 2 ** (power - half));
}

// Bit for bit; angles, which go through acos of another library of mathematics, to 1e-14.
export function same_value(id, shown, native) {
  if (native === undefined) return false;
  return Object.is(shown, native) || (id === 'gamma' && Math.abs(shown - native) <= 1e-14);
}
