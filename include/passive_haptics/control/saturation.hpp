/// @file
/// Torque limits.
#pragma once

#include <passive_haptics/core/matrix.hpp>

#include <algorithm>
#include <cmath>

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
  bool limited;              ///< True if some limit was reached.
};

/// scale * t within limits [N m] >= 0; t [N m per N] and scale >= 0 [N] finite, their product may overflow.
template <class T, int Brakes>
saturated_torque<T, Brakes> saturate(const vector<T, Brakes>& t, T scale, const vector<T, Brakes>& limit,
                                     saturation policy) {
  const auto exceeds = [&](int i) { return std::abs(t[i]) * scale > limit[i]; };
  T factor = scale;
  if (policy == saturation::keep_direction) {
    unrolled<Brakes>([&](auto i) {
      if (exceeds(i)) factor = std::min(factor, limit[i] / std::abs(t[i]));
    });
  }
  saturated_torque<T, Brakes> result{{}, false};
  unrolled<Brakes>([&](auto i) { result.limited |= exceeds(i); });
  unrolled<Brakes>(
      [&](auto i) { result.torque[i] = std::copysign(std::min(std::abs(factor * t[i]), limit[i]), t[i]); });
  return result;
}

}  // namespace passive_haptics
