/// Sign rule of the brakes, with Karnopp's dead band:
///
///     s_i = sgn(w_i)    if the brake slips, |w_i| > its rate dead band,
///     s_i = sgn(th_i)   if it sticks and the hand torque on it exceeds its torque dead band,
///     s_i = 0           otherwise: it may hold either way.
///
/// A brake produces only torques with s_i t_i <= 0 (3).
#pragma once

#include <passive_haptics/brake/brake_parameters.hpp>
#include <passive_haptics/core/linear/lanes.hpp>

#include <cmath>

namespace passive_haptics {

/// True if a brake slips: its rate exceeds its dead band. For a number or lanes.
template <class T>
auto slips(const T& rate, const T& rate_dead_band) {
  using std::abs;
  return abs(rate) > rate_dead_band;
}

/// Sign s of a brake with rate w and hand torque th. Dead bands are >= 0. For a number or lanes.
template <class T>
T brake_sign(const T& w, const T& th, const T& rate_dead_band, const T& torque_dead_band) {
  using std::abs;
  const T push = select(abs(th) > torque_dead_band, th, T(0));
  return sgn(select(slips(w, rate_dead_band), w, push));
}

/// Signs s (m) of all brakes, exactly -1, 0 or 1, from their rates w [rad/s] and the hand torques th [N m] on
/// their axes. Pass th = 0 if the hand force is unknown. Without a rate_dead_band, s = sgn(w).
template <class T, int Brakes, class B = brake_parameters<T, Brakes>>
vector<T, Brakes> brake_signs(const vector<T, Brakes>& w, const vector<T, Brakes>& th, const B& brakes) {
  using each = lanes<T, Brakes>;
  if constexpr (StickingBrakes<B, T, Brakes>)
    return brake_sign<each>(w, th, brakes.rate_dead_band, torque_dead_bands_of<T, Brakes>(brakes));
  else return sgn(each(w));
}

/// True if some brake is at rest, so that its hand torque decides the sign. False without a rate_dead_band.
template <class T, int Brakes, class B = brake_parameters<T, Brakes>>
bool any_sticks([[maybe_unused]] const vector<T, Brakes>& w, [[maybe_unused]] const B& brakes) {
  bool sticks = false;
  if constexpr (StickingBrakes<B, T, Brakes>)
    unrolled<Brakes>([&](auto i) { sticks |= !slips(w[i], brakes.rate_dead_band[i]); });
  return sticks;
}

}  // namespace passive_haptics
