// Where a point of the base frame [m] is on the screen [CSS pixels], and back. The plane is seen from
// above, y up; space by a parallel projection of its own, turned by two angles.

import {dot, length_of, minus, plus, times} from './vectors.js';

export function plane_camera(scale, origin) {
  return {
    is_space: false,
    scale,
    point: p => [origin[0] + scale * p[0], origin[1] - scale * p[1]],
    // The direction of a vector of unit length, as pixels for one unit.
    vector: f => [f[0], -f[1]],
    depth: () => 0,
    // The point of the plane under a pixel.
    back: pixel => [(pixel[0] - origin[0]) / scale, (origin[1] - pixel[1]) / scale, 0],
    back_vector: d => [d[0], -d[1], 0],
    towards: [0, 0, 0],
  };
}

// yaw turns about z, pitch lifts the eye over the plane z = 0; both [rad]. centre is seen at middle.
function space_camera(scale, middle, centre, yaw, pitch) {
  const cy = Math.cos(yaw),
    sy = Math.sin(yaw),
    cp = Math.cos(pitch),
    sp = Math.sin(pitch);
  const right = [cy, sy, 0],
    up = [-sy * sp, cy * sp, cp],
    towards = [sy * cp, -cy * cp, sp];
  const vector = f => [dot(f, right), -dot(f, up)];
  const from = p => minus(p, centre);
  const back_vector = d => plus(times(d[0], right), up, -d[1]);
  return {
    is_space: true,
    scale,
    point: p => plus(middle, vector(from(p)), scale),
    vector,
    // How near a point is to the eye [m].
    depth: p => dot(from(p), towards),
    // The point under a pixel, in the plane parallel to the screen through p.
    back: (pixel, p) =>
      plus(plus(centre, back_vector(minus(pixel, middle)), 1 / scale), towards, dot(from(p), towards)),
    back_vector,
    // The unit vector to the eye.
    towards,
  };
}

// The camera that shows a box (low x y z, high x y z) in a picture of this size, with a margin [pixels].
export function fitting_camera(box, is_space, width, height, margin, yaw = 0, pitch = 0) {
  const centre = [0, 1, 2].map(i => (box[i] + box[i + 3]) / 2);
  const size = [0, 1, 2].map(i => Math.max(1e-9, box[i + 3] - box[i]));
  const room = [Math.max(20, width - margin.left - margin.right), Math.max(20, height - margin.top - margin.bottom)];
  const middle = [margin.left + room[0] / 2, margin.top + room[1] / 2];
  if (!is_space) {
    const scale = Math.min(room[0] / size[0], room[1] / size[1]);
    return plane_camera(scale, [middle[0] - scale * centre[0], middle[1] + scale * centre[1]]);
  }
  return space_camera(Math.min(...room) / (0.86 * length_of(size)), middle, centre, yaw, pitch);
}
