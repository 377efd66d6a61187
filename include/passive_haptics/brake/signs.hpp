/// @file
/// Which way each brake can pull: the sign rule with Karnopp's dead band.
#pragma once

#include <passive_haptics/brake/brake_parameters.hpp>

#include <cmath>

namespace passive_haptics {

/// True where a brake turns faster than its dead band (slip); else it is at rest (stick).
template <class T>
bool slips(T rate, T rate_dead_band) {
  return std::abs(rate) > rate_dead_band;
}

/// Sign s of one brake: that of its rate w in slip, else that of the hand torque th on it, else 0. A brake
/// produces only torques with s t <= 0 (3). s = 0 (at rest, nobody pushes) restricts nothing.
/// Dead bands are >= 0.
template <class T>
T brake_sign(T w, T th, T rate_dead_band, T torque_dead_band) {
  if (slips(w, rate_dead_band)) return std::copysign(T(1), w);
  return std::abs(th) > torque_dead_band ? std::copysign(T(1), th) : T(0);
}

/// Signs s (m) of all brakes from their rates w [rad/s] and the hand torques th [N m] on their axes, each
/// exactly -1, 0 or 1. Pass th = 0 where no hand force is known. Without a rate_dead_band s = sgn(w).
template <class T, int Brakes, class B = brake_parameters<T, Brakes>>
vector<T, Brakes> brake_signs(const vector<T, Brakes>& w, const vector<T, Brakes>& th, const B& brakes) {
  vector<T, Brakes> s;
  unrolled<Brakes>([&](auto i) {
    if constexpr (StickingBrakes<B, T, Brakes>)
      s[i] = brake_sign(w[i], th[i], brakes.rate_dead_band[i], torque_dead_band_of<T>(brakes, i));
    else s[i] = w[i] > T(0) ? T(1) : (w[i] < T(0) ? T(-1) : T(0));
  });
  return s;
}

/// True if some brake is at rest: then hand torques decide its sign. False without a rate_dead_band.
template <class T, int Brakes, class B = brake_parameters<T, Brakes>>
bool any_sticks([[maybe_unused]] const vector<T, Brakes>& w, [[maybe_unused]] const B& brakes) {
  bool sticks = false;
  if constexpr (StickingBrakes<B, T, Brakes>)
    unrolled<Brakes>([&](auto i) { sticks |= !slips(w[i], brakes.rate_dead_band[i]); });
  return sticks;
}

}  // namespace passive_haptics
