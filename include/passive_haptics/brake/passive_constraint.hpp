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
  return (td < T(0) && w > T(0)) || (td > T(0) && w < T(0)) ? td : T(0);
}

/// Torque of a brake at rest (3b): holds the hand torque th if td opposes it, else 0 (released).
///
/// As printed, (3b) returns -th: it assumes that the brake holds. A brake holds up to its command, so this
/// returns -sgn(th) min(|td|, |th|), which equals (3b) wherever |td| >= |th|.
template <class T>
T stick_torque(T td, T th) {
  const T held = slip_torque(td, th);
  return std::abs(held) <= std::abs(th) ? held : -th;
}

/// Torque that a brake of sign s = brake_sign(w, th, ...) makes of a command td: (3a) where it slips, else
/// (3b). Guaranteed: s t <= 0 exactly, |t| <= |td|.
template <class T>
T passive_torque(T td, T w, T th, T s, T rate_dead_band) {
  if (!(s * td < T(0))) return T(0);  // td does not oppose, or at rest nobody pushes
  return slips(w, rate_dead_band) || std::abs(td) <= std::abs(th) ? td : -th;
}

/// Torques (m) [N m] that brakes of signs s = brake_signs(w, th, brakes) produce when torques td are
/// commanded. Without a rate_dead_band (3a) alone.
template <class T, int Brakes, class B = brake_parameters<T, Brakes>>
vector<T, Brakes> passive_torque(const vector<T, Brakes>& td, const vector<T, Brakes>& w,
                                 const vector<T, Brakes>& th, const vector<T, Brakes>& s, const B& brakes) {
  vector<T, Brakes> t;
  unrolled<Brakes>([&](auto i) {
    if constexpr (StickingBrakes<B, T, Brakes>)
      t[i] = passive_torque(td[i], w[i], th[i], s[i], brakes.rate_dead_band[i]);
    else t[i] = s[i] * td[i] < T(0) ? td[i] : T(0);
  });
  return t;
}

/// Torques (m) [N m] that the brakes produce when torques td are commanded, at rates w and hand torques th.
template <class T, int Brakes, class B = brake_parameters<T, Brakes>>
vector<T, Brakes> passive_torque(const vector<T, Brakes>& td, const vector<T, Brakes>& w,
                                 const vector<T, Brakes>& th, const B& brakes) {
  return passive_torque(td, w, th, brake_signs(w, th, brakes), brakes);
}

}  // namespace passive_haptics
