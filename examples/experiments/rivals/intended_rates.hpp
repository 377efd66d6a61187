// Signs of actual or impending brake motion.
#pragma once

#include <passive_haptics/passive_haptics.hpp>

namespace experiments {

namespace ph = passive_haptics;

// Rates of the brakes [rad/s or m/s]. Brakes at rest count as moving at their dead band in the direction of
// the hand torque, 0 without one. E times this vector has the direction of the handle's motion, actual or
// after a release.
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

// Torque [N m] of a brake with sign s that holds with `capacity`; either sign for s = 0.
template <class T>
T holding_torque(T s, T capacity) {
  return s > T(0) ? -capacity : capacity;
}

}  // namespace experiments
