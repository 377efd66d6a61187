/// @file
/// Torque limits.
#pragma once

#include <passive_haptics/brake/torque_interval.hpp>
#include <passive_haptics/core/linear/lane_products.hpp>

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
  const lanes wanted = t, bound = limit, size = abs(wanted);
  const auto is_over = size > bound;
  lanes<T, Brakes> within = wanted;
  if (policy == saturation::keep_direction) within = within * min_value(select(is_over, bound / size, T(1)));
  return {max(min(within, bound), -bound), any(is_over)};
}

/// Torques t [N m] within the limits and the intervals of the brakes, where they have some.
template <class B, class T, int Brakes>
saturated_torque<T, Brakes> within_limits(const vector<T, Brakes>& t, const B& brakes, saturation policy) {
  if constexpr (SwitchableBrakes<B, T, Brakes>)
    return saturate(t, passive_haptics::torque_bounds_of(brakes, t), policy);
  else if constexpr (LimitedBrakes<B, T, Brakes>) return saturate(t, brakes.torque_limit, policy);
  else return {t, false};
}

/// Whether some torque t [N m] is at a limit of its brake. A brake that is off is at none.
template <class B, class T, int Brakes>
bool any_at_limit(const vector<T, Brakes>& t, const B& brakes) {
  if constexpr (SwitchableBrakes<B, T, Brakes>) {
    const vector<T, Brakes> bound = passive_haptics::torque_bounds_of(brakes, t);
    return (t.array().abs() >= bound.array() && t.array() != T(0)).any();
  } else {
    const vector<T, Brakes> limit = passive_haptics::torque_limits_of<T, Brakes>(brakes);
    return (t.array().abs() >= limit.array()).any();
  }
}

}  // namespace passive_haptics
