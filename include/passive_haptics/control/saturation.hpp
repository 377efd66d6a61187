/// Torque limits.
#pragma once

#include <passive_haptics/brake/torque_interval.hpp>
#include <passive_haptics/core/linear/lane_products.hpp>

namespace passive_haptics {

/// Handling of torques that exceed a limit.
enum class saturation {
  keep_direction,  ///< Scales all brakes by one factor, so that the force keeps its direction.
  clamp_each,      ///< Limits each brake separately: a larger force in another direction.
};

/// Torques within their limits.
template <class T, int Brakes>
struct saturated_torque {
  vector<T, Brakes> torque;  ///< [N m], |t_i| <= limit_i exactly.
  bool limited;              ///< True if a torque exceeded its limit.
};

/// Scales the torques by a in [0, 1].
template <class T, int Brakes>
saturated_torque<T, Brakes> operator*(T a, const saturated_torque<T, Brakes>& t) {
  return {a * t.torque, t.limited};
}

/// Limits finite torques t [N m] to limits [N m] >= 0. Applied before or after the alpha of a law.
template <class T, int Brakes>
saturated_torque<T, Brakes> saturate(const vector<T, Brakes>& t, const vector<T, Brakes>& limit,
                                     saturation policy) {
  const lanes wanted = t, bound = limit, size = abs(wanted);
  const auto is_over = size > bound;
  lanes<T, Brakes> within = wanted;
  if (policy == saturation::keep_direction) within = within * min_value(select(is_over, bound / size, T(1)));
  return {max(min(within, bound), -bound), any(is_over)};
}

/// Limits torques t [N m] to the limits and intervals of the brakes, if they have any.
template <class B, class T, int Brakes>
saturated_torque<T, Brakes> within_limits(const vector<T, Brakes>& t, const B& brakes, saturation policy) {
  if constexpr (SwitchableBrakes<B, T, Brakes>)
    return saturate(t, passive_haptics::torque_bounds_of(brakes, t), policy);
  else if constexpr (LimitedBrakes<B, T, Brakes>) return saturate(t, brakes.torque_limit, policy);
  else return {t, false};
}

/// True if a torque t [N m] is at a limit of its brake. A brake that is off is never at a limit.
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
