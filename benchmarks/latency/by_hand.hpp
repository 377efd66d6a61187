// The control cycle of the tendon device along one plane wall under direct control, written by hand for this
// device with a brake in each half of a register: one branch, free space or contact, and every guarantee of
// the library's cycle: NaN and infinity release, dead bands, a maximum approximation angle, det = 0.
#pragma once

#include <passive_haptics/core/scalar/sine_cosine.hpp>

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

using pair [[gnu::vector_size(16)]] = double;       // of brake 1 and brake 2
using truths [[gnu::vector_size(16)]] = long long;  // all bits set where true

inline constexpr truths sign_bit{-0x7fffffffffffffff - 1, -0x7fffffffffffffff - 1};

[[gnu::always_inline]] inline pair select(truths where, pair a, pair b) {
  return pair((truths(a) & where) | (truths(b) & ~where));
}
[[gnu::always_inline]] inline pair size(pair x) { return pair(truths(x) & ~sign_bit); }
template <class Two>
[[gnu::always_inline]] inline Two swapped(Two x) {
  return __builtin_shufflevector(x, x, 1, 0);
}

[[gnu::always_inline]] inline command step(const device& d, const wall& wall, const measurement& at) {
  const pair q{at.q1, at.q2}, qd{at.qd1, at.qd2}, Fh{at.fx, at.fy}, zero{0, 0}, one{1, 1};
  const truths finite = (q * zero) * qd * Fh * at.time == zero;
  if ((finite[0] & finite[1]) == 0) return {0, 0, region::fault};

  const auto [first, second] = passive_haptics::sine_cosine(at.q1, at.q1 + at.q2);
  const double lx = d.length_2 * second.cosine, ly = d.length_2 * second.sine;
  const double x = d.length_1 * first.cosine + lx, y = d.length_1 * first.sine + ly;
  const double depth = wall.offset - wall.nx * x - wall.ny * y;
  if (!(depth > 0)) return {0, 0, region::free};
  const double Fd = wall.stiffness * depth;

  const double e2x = -d.reduction_2 * ly, e2y = d.reduction_2 * lx;
  const pair ex{-y - e2x, e2x}, ey{x - e2y, e2y};  // E = J T^-1
  const pair w{at.qd1, at.qd1 + at.qd2 * d.per_reduction_2};
  const pair t = ex * wall.nx + ey * wall.ny, th = ex * at.fx + ey * at.fy;  // t for 1 N along n
  const pair felt = select(size(th) > d.torque_dead_band, th, zero);
  const pair way = select(size(w) > d.rate_dead_band, w, felt);

  // Each brake alone, the other released: at right angles to the other's column
  const pair ox = swapped(ex), oy = swapped(ey), square = ox * ox + oy * oy;
  const pair cross = ex * oy - ey * ox, along = wall.nx * oy - wall.ny * ox;
  const pair area = select(cross * cross > d.rounding * d.rounding * square * swapped(square), cross, zero);
  const pair alone = area / along;
  const truths drives = way * t > zero, some = drives | swapped(drives);
  const truths taken =
      swapped(drives) & (way * alone <= zero) & (along * along >= d.min_cosine * d.min_cosine * square);
  const pair command = select(some, select(taken, alone, zero), t);

  const pair power = t * w;
  // alpha Fd, (12): std::max and std::min of numbers would be branches
  const pair pressing = one * -(at.fx * wall.nx + at.fy * wall.ny), demanded = one * Fd;
  const pair pushed = pressing > zero ? pressing : zero;
  const pair wanted = pushed < demanded ? pushed : demanded;
  const pair scaled = size(command) * select(power + swapped(power) > zero, wanted, demanded);
  const truths defined = scaled * zero == zero;
  if ((defined[0] & defined[1]) == 0) return {0, 0, region::fault};
  const pair limit = one * d.torque_limit, capacity = limit < scaled ? limit : scaled;
  const auto where = 1 + 2 * (some[0] & 1) - (some[0] & (taken[0] | taken[1]) & 1);  // no branch
  return {capacity[0], capacity[1], static_cast<region>(where)};
}

}  // namespace by_hand
