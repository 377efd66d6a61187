// The control cycle of the tendon device, one plane wall and direct control, as one would write it by hand
// for this device alone: scalars, two divisions, no checks of its input and no account of what it did.
#pragma once

#include <passive_haptics/core/scalar/sine_cosine.hpp>

#include <algorithm>
#include <cmath>

namespace by_hand {

struct device {
  double length_1, length_2, reduction_2, per_reduction_2;  // [m], [m], [1], [1]
  // Of both brakes [rad/s], [N m], [N m]
  double rate_dead_band, torque_limit, torque_dead_band;
  double min_cosine, rounding;  // [1]
};

struct wall {
  double nx, ny, offset;  // n . x = offset on the surface [m]
  double stiffness;       // [N/m]
};

struct measurement {
  double q1, q2, qd1, qd2;  // [rad], [rad/s]
  double fx, fy;            // hand force [N]
  double time;              // [s]
};

enum class region { free, exact, approximate, none, fault };

struct command {
  double capacity_1, capacity_2;  // [N m]
  region where;
};

inline command step(const device& d, const wall& wall, const measurement& at) {
  const auto [s1, c1] = passive_haptics::sine_cosine(at.q1);
  const auto [s12, c12] = passive_haptics::sine_cosine(at.q1 + at.q2);
  const double lx = d.length_2 * c12, ly = d.length_2 * s12;
  const double x = d.length_1 * c1 + lx, y = d.length_1 * s1 + ly;
  const double depth = wall.offset - wall.nx * x - wall.ny * y;
  if (!(depth > 0)) return {0, 0, region::free};
  const double Fd = wall.stiffness * depth;

  // E = J T^-1: brake 2 turns link 2 alone by k2, brake 1 takes that back
  const double e2x = -d.reduction_2 * ly, e2y = d.reduction_2 * lx;
  const double e1x = -y - e2x, e1y = x - e2y;
  const double w1 = at.qd1, w2 = at.qd1 + at.qd2 / d.reduction_2;
  const double t1 = e1x * wall.nx + e1y * wall.ny, t2 = e2x * wall.nx + e2y * wall.ny;  // for 1 N along n
  const double th1 = e1x * at.fx + e1y * at.fy, th2 = e2x * at.fx + e2y * at.fy;
  const double s1_ = std::copysign(1.0, std::abs(w1) > d.rate_dead_band ? w1 : th1);
  const double s2_ = std::copysign(1.0, std::abs(w2) > d.rate_dead_band ? w2 : th2);

  double command_1 = t1, command_2 = t2;
  region where = region::exact;
  if (t1 * s1_ > 0 || t2 * s2_ > 0) {
    // R_1 makes no velocity of brake 2, so it is at right angles to e2; and the other way round
    const double side = std::copysign(1.0, e1x * e2y - e1y * e2x);
    const double r1x = -side * s1_ * e2y, r1y = side * s1_ * e2x;
    const double r2x = side * s2_ * e1y, r2y = -side * s2_ * e1x;
    const double along_1 = wall.nx * r1x + wall.ny * r1y, along_2 = wall.nx * r2x + wall.ny * r2y;
    const double near_1 = std::max(along_1, 0.0), near_2 = std::max(along_2, 0.0);
    const bool first = near_1 * near_1 * (e1x * e1x + e1y * e1y) >= near_2 * near_2 * (e2x * e2x + e2y * e2y);
    const double along = first ? along_1 : along_2;
    if (!(along > 0)) return {0, 0, region::none};
    const double scale = 1 / along;
    command_1 = first ? (e1x * r1x + e1y * r1y) * scale : 0;
    command_2 = first ? 0 : (e2x * r2x + e2y * r2y) * scale;
    where = region::approximate;
  }
  double wanted = Fd;  // alpha Fd, (12)
  if (t1 * w1 + t2 * w2 > 0) wanted = std::clamp(-(at.fx * wall.nx + at.fy * wall.ny), 0.0, Fd);
  return {std::min(std::abs(command_1) * wanted, d.torque_limit),
          std::min(std::abs(command_2) * wanted, d.torque_limit), where};
}

}  // namespace by_hand
