// Which way each brake turns, or is about to turn.
#pragma once

#include <passive_haptics/passive_haptics.hpp>

namespace experiments {

namespace ph = passive_haptics;

// Rates of the brakes [rad/s or m/s], those at rest taken to turn at their dead band where the hand pushes
// them; 0 where nobody pushes. So E times it has the direction in which the handle moves, or would if it
// were let go.
template <class M, class EMatrix, class B>
ph::brake_vector<M> intended_rates(const ph::brake_situation<M, EMatrix, B>& device) {
  using T = typename M::scalar;
  ph::brake_vector<M> w;
  ph::unrolled<M::brake_count>([&](auto i) {
    const T band = ph::rate_dead_band_of<T>(device.brakes, i);
    w[i] = ph::slips(device.w[i], band) ? device.w[i] : device.s[i] * band;
  });
  return w;
}

// The torque [N m] that makes a brake of sign s hold with `capacity`; either way where s = 0.
template <class T>
T holding_torque(T s, T capacity) {
  return s > T(0) ? -capacity : capacity;
}

}  // namespace experiments
