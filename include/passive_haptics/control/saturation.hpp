/// @file
/// Torque limits.
#pragma once

#include <passive_haptics/core/matrix.hpp>

namespace passive_haptics {

/// What gives way where a brake cannot follow.
enum class saturation {
  keep_direction,  ///< All brakes are scaled by one factor: the force keeps its direction.
  clamp_each,      ///< Each brake gives what it can: more force, in another direction.
};

/// Torques within their limits.
template <class T, int Brakes>
struct saturated_torque {
  vector<T, Brakes> torque;  ///< [N m], |t_i| <= limit_i exactly.
  bool limited;              ///< True if some torque was over its limit.
};

/// a t, of the same brakes: a in [0, 1].
template <class T, int Brakes>
saturated_torque<T, Brakes> operator*(T a, const saturated_torque<T, Brakes>& t) {
  return {a * t.torque, t.limited};
}

/// Torques t [N m], finite, within limits [N m] >= 0. It may stand before or after a law's alpha: cut to what
/// the brakes can make and then scaled, or scaled and then cut.
template <class T, int Brakes>
saturated_torque<T, Brakes> saturate(const vector<T, Brakes>& t, const vector<T, Brakes>& limit,
                                     saturation policy) {
  const auto size = t.array().abs();
  const auto is_over = (size > limit.array());
  if (!is_over.any()) return {t, false};
  const T factor =
      policy == saturation::clamp_each ? T(1) : is_over.select(limit.array() / size, T(1)).minCoeff();
  return {(factor * t.array()).max(-limit.array()).min(limit.array()), true};
}

}  // namespace passive_haptics
