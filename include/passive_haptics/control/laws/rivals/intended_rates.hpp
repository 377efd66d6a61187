/// @file
/// Which way each brake turns, or is about to turn.
#pragma once

#include <passive_haptics/brake/signs.hpp>
#include <passive_haptics/control/control_law.hpp>

namespace passive_haptics {

/// Rates of the brakes [rad/s or m/s], those at rest taken to turn at their dead band where the hand pushes
/// them; 0 where nobody pushes. So E times it has the direction in which the handle moves, or would if it
/// were let go.
template <class M, class EMatrix, class B>
brake_vector<M> intended_rates(const brake_situation<M, EMatrix, B>& device) {
  using T = typename M::scalar;
  brake_vector<M> s = device.s, w;
  if constexpr (detail::names_torque_interval<B>)  // s of a one-way brake at rest may be that of its way
    s = brake_signs(device.w, device.th, device.brakes);
  unrolled<M::brake_count>([&](auto i) {
    const T band = rate_dead_band_of<T>(device.brakes, i);
    w[i] = slips(device.w[i], band) ? device.w[i] : s[i] * band;
  });
  return w;
}

/// The torque [N m] that makes a brake of sign s hold with `capacity`; either way where s = 0.
template <class T>
T holding_torque(T s, T capacity) {
  return s > T(0) ? -capacity : capacity;
}

}  // namespace passive_haptics
