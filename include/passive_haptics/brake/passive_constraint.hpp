/// @file
/// What a brake makes of a commanded torque: the passive constraint (3).
#pragma once

#include <passive_haptics/brake/signs.hpp>

namespace passive_haptics {

/// Torques (m) [N m] that brakes produce when torques td are commanded, at rates w, hand torques th and signs
/// s = brake_signs(w, th, brakes):
///
///     slip (3a):   t = -sgn(w) |td|               where td opposes the motion, else 0 (released);
///     stick (3b):  t = -sgn(th) min(|td|, |th|)   where td opposes the hand, else 0 (released).
///
/// As printed, (3b) is -th: it assumes that the brake holds. A brake holds up to its command, so this equals
/// (3b) wherever |td| >= |th|. Brakes without a rate_dead_band only slip.
///
/// Guaranteed: s_i t_i <= 0 and |t_i| <= |td_i| exactly. Where a self-motion settles a cycle gives -s_i
/// |td_i| for td_i: a brake that is commanded resists the rate that it has.
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

/// Torques (m) [N m] that brakes produce when torques td are commanded, with s = brake_signs(w, th, brakes).
template <class T, int Brakes, class B = brake_parameters<T, Brakes>>
vector<T, Brakes> passive_torque(const vector<T, Brakes>& td, const vector<T, Brakes>& w,
                                 const vector<T, Brakes>& th, const B& brakes) {
  return passive_torque(td, w, th, brake_signs(w, th, brakes), brakes);
}

}  // namespace passive_haptics
