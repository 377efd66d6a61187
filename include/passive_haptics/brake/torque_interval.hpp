/// Torque intervals of brakes that are off or one-way:
///
///     t_i in [lower_i, upper_i], |t_i| <= limit_i, s_i t_i <= 0 (3)
///
/// A brake limited to {0} is off. A one-way brake has the sign of its direction, also at rest.
#pragma once

#include <passive_haptics/brake/brake_concepts.hpp>

#include <algorithm>
#include <type_traits>

namespace passive_haptics {

/// Maximum torque [N m], >= 0, of brake i in the direction of `torque`; infinite if unbounded.
template <class T, class B>
T torque_bound_of(const B& brakes, int i, [[maybe_unused]] T torque) {
  const T limit = passive_haptics::torque_limit_of<T>(brakes, i);
  if constexpr (detail::names_torque_interval<B>)
    return std::min(limit, torque > T(0) ? brakes.torque_upper[i] : -brakes.torque_lower[i]);
  else return limit;
}

/// Bounds of all brakes in the directions of the torques t, as from torque_bound_of.
template <class B, class T, int Brakes>
vector<T, Brakes> torque_bounds_of(const B& brakes, const vector<T, Brakes>& t) {
  vector<T, Brakes> bound;
  unrolled<Brakes>([&](auto i) { bound[i] = passive_haptics::torque_bound_of<T>(brakes, i, t[i]); });
  return bound;
}

/// Maximum torque [N m], >= 0, of each brake in either direction.
template <class T, int Brakes, class B>
vector<T, Brakes> max_torques_of(const B& brakes) {
  const vector<T, Brakes> limit = passive_haptics::torque_limits_of<T, Brakes>(brakes);
  if constexpr (SwitchableBrakes<B, T, Brakes>)
    return limit.cwiseMin(brakes.torque_upper.cwiseMax(-brakes.torque_lower));
  else return limit;
}

/// Signs s (m) for the torques that brakes can produce: as from brake_signs, but a one-way brake at rest, s =
/// 0, has the sign of its direction. Returns s itself for brakes without an interval.
template <class B, class T, int Brakes>
decltype(auto) signs_within(const vector<T, Brakes>& s, [[maybe_unused]] const B& brakes) {
  if constexpr (SwitchableBrakes<B, T, Brakes>) {
    vector<T, Brakes> signs;
    unrolled<Brakes>([&](auto i) {
      const bool up = passive_haptics::torque_bound_of<T>(brakes, i, T(1)) > T(0),
                 down = passive_haptics::torque_bound_of<T>(brakes, i, T(-1)) > T(0);
      signs[i] = s[i] != T(0) ? s[i] : static_cast<T>(down) - static_cast<T>(up);
    });
    return signs;
  } else {
    return (s);
  }
}

/// Replaces a vector of brakes_off if all are on.
struct all_brakes_on {};

/// 1 for each brake that is off with signs s from signs_within, else 0; all_brakes_on without intervals.
template <class B, class T, int Brakes>
auto brakes_off(const vector<T, Brakes>& s, [[maybe_unused]] const B& brakes) {
  if constexpr (SwitchableBrakes<B, T, Brakes>) {
    vector<T, Brakes> off;
    unrolled<Brakes>([&](auto i) {
      const bool up = s[i] <= T(0) && passive_haptics::torque_bound_of<T>(brakes, i, T(1)) > T(0),
                 down = s[i] >= T(0) && passive_haptics::torque_bound_of<T>(brakes, i, T(-1)) > T(0);
      off[i] = static_cast<T>(!up && !down);
    });
    return off;
  } else {
    return all_brakes_on();
  }
}

namespace detail {

template <class Off>
bool is_off([[maybe_unused]] const Off& off, [[maybe_unused]] int i) {
  if constexpr (std::is_same_v<Off, all_brakes_on>) return false;
  else return off[i] != 0;
}

}  // namespace detail

}  // namespace passive_haptics
