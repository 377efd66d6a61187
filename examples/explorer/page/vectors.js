// Vectors as arrays: forces, velocities and places of three numbers, pixels of two.

export const length_of = a => Math.hypot(...a);
export const dot = (a, b) => a.reduce((sum, c, i) => sum + c * b[i], 0);
export const times = (s, a) => a.map(c => s * c);
// a + s b
export const plus = (a, b, s = 1) => a.map((c, i) => c + s * b[i]);
export const minus = (a, b) => plus(a, b, -1);
export const unit = a => times(1 / (length_of(a) || 1), a);
export const cross = (a, b) => [0, 1, 2].map(i => a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3]);

// Pixels from a pixel on: s along a direction and t to its side.
export function frame_at(from, direction) {
  const a = unit(direction);
  return (s, t = 0) => [from[0] + s * a[0] - t * a[1], from[1] + s * a[1] + t * a[0]];
}
