// The control cycle of an XY table with brakes of no limit and no dead band along one plane wall, without
// direct control, as one would write it by hand for this device alone. It keeps the promises of the library's
// step that bear on it: NaN and infinity are refused, a brake at rest has sign 0, what cannot be displayed
// within max_angle is exactly zero.
#pragma once

#include <algorithm>
#include <cmath>

namespace by_hand {

struct wall {
  double nx, ny, px, py;  // unit vector out of the wall, a point of its surface [m]
  double stiffness;       // [N/m]
};

struct measurement {
  double time, x, y, vx, vy;  // [s], [m], [m/s]
};

enum class fault { none, state_not_finite, contact_not_finite, parameters_invalid, result_not_finite };

struct command {
  double capacity_x = 0, capacity_y = 0;  // [N]
  fault outcome = fault::none;
};

// A force along the motion; a product could underflow
inline bool drives(double v, double f) { return (v > 0 && f > 0) || (v < 0 && f < 0); }

// min_cosine: of the largest angle between desired and displayed force
[[gnu::noinline]] inline command step(const wall& wall, double min_cosine, const measurement& at) {
  if (!(at.time * 0 + at.x * 0 + at.y * 0 + at.vx * 0 + at.vy * 0 == 0))
    return {.outcome = fault::state_not_finite};
  const double distance = wall.nx * (at.x - wall.px) + wall.ny * (at.y - wall.py);
  if (distance >= 0) return {};
  const double Fd = wall.stiffness * -distance;
  if (!(Fd * 0 + wall.nx * 0 + wall.ny * 0 == 0)) return {.outcome = fault::contact_not_finite};
  if (!(Fd > 0)) return {};

  // A brake that would have to drive its axis is released; the force along n is made by the other
  double fx = wall.nx, fy = wall.ny;
  const bool drives_x = drives(at.vx, fx), drives_y = drives(at.vy, fy);
  if (drives_x || drives_y) {
    if (drives_x) fx = 0;
    if (drives_y) fy = 0;
    const double square = fx * fx + fy * fy;
    if (!(square >= min_cosine * min_cosine))
      return {.outcome = min_cosine * 0 == 0 ? fault::none : fault::parameters_invalid};
    fx /= square;
    fy /= square;
  }
  const command command{std::abs(Fd * fx), std::abs(Fd * fy)};
  if (!(command.capacity_x * 0 + command.capacity_y * 0 == 0)) return {.outcome = fault::result_not_finite};
  return command;
}

}  // namespace by_hand
