/// @file
/// What a brake makes of a commanded torque: the passive constraint (3).
#pragma once

#include <passive_haptics/brake/signs.hpp>

#include <algorithm>
#include <cmath>

namespace passive_haptics {

/// Torque of a slipping brake (3a): -sgn(w) |td| if td opposes the motion, else 0 (released).
template <class T>
T slip_torque(T td, T w) {
  return sgn(td) * sgn(w) < T(0) ? -sgn(w) * std::abs(td) : T(0);
}

/// Torque of a brake at rest (3b): holds the hand torque th if td opposes it, else 0 (released).
///
/// As printed, (3b) returns -th: it assumes that the brake holds. A brake holds up to its command, so this
/// returns -sgn(th) min(|td|, |th|), which equals (3b) wherever |td| >= |th|.
template <class T>
T stick_torque(T td, T th) {
  return sgn(td) * sgn(th) < T(0) ? -sgn(th) * std::min(std::abs(td), std::abs(th)) : T(0);
}

/// Torques (m) [N m] that the brakes produce when torques td are commanded, at rates w and hand torques th.
/// Guaranteed: s_i t_i <= 0 exactly, |t_i| <= |td_i|.
template <class T, int Brakes>
vector<T, Brakes> passive_torque(const vector<T, Brakes>& td, const vector<T, Brakes>& w,
                                 const vector<T, Brakes>& th, const brake_parameters<T, Brakes>& brakes) {
  vector<T, Brakes> t;
  for (int i = 0; i < Brakes; ++i) {
    const bool pushed = std::abs(th[i]) > brakes.torque_dead_band[i];
    t[i] = slips(w[i], brakes.rate_dead_band[i]) ? slip_torque(td[i], w[i])
                                                 : (pushed ? stick_torque(td[i], th[i]) : T(0));
  }
  return t;
}

}  // namespace passive_haptics
