/// Torques that brakes produce for a command: the passive constraint (3).
#pragma once

#include <passive_haptics/brake/signs.hpp>

namespace passive_haptics {

/// Torques (m) [N m] for commands td, rates w, hand torques th and signs s = brake_signs(w, th, brakes):
///
///     slip (3a):   t = -sgn(w) |td|               if td opposes the motion, else 0 (released);
///     stick (3b):  t = -sgn(th) min(|td|, |th|)   if td opposes the hand, else 0 (released).
///
/// The paper prints (3b) as -th, which is equal if |td| >= |th|. Brakes without a rate_dead_band slip.
///
/// Guarantees s_i t_i <= 0 and |t_i| <= |td_i| exactly. With a settled self-motion, a cycle passes -s_i
/// |td_i| as td_i: each commanded brake resists its current rate.
/// @equation{3}
template <class T, int Brakes, class B = brake_parameters<T, Brakes>>
vector<T, Brakes> passive_torque(const vector<T, Brakes>& td, const vector<T, Brakes>& w,
                                 const vector<T, Brakes>& th, const vector<T, Brakes>& s, const B& brakes) {
  const lanes commanded = td, push = th;
  const auto opposes = lanes(s) * commanded < T(0);
  if constexpr (StickingBrakes<B, T, Brakes>) {
    const auto slips_or_is_overcome =
        slips<lanes<T, Brakes>>(w, brakes.rate_dead_band) | (abs(commanded) <= abs(push));
    return select(opposes, select(slips_or_is_overcome, commanded, -push), T(0));
  } else {
    return select(opposes, commanded, T(0));
  }
}

/// As above, with signs from brake_signs(w, th, brakes).
template <class T, int Brakes, class B = brake_parameters<T, Brakes>>
vector<T, Brakes> passive_torque(const vector<T, Brakes>& td, const vector<T, Brakes>& w,
                                 const vector<T, Brakes>& th, const B& brakes) {
  return passive_torque(td, w, th, brake_signs(w, th, brakes), brakes);
}

}  // namespace passive_haptics
