// Holds the brakes that move into the wall, so that the remaining motion leads out.
#pragma once

#include "intended_rates.hpp"

#include <algorithm>
#include <cmath>

namespace experiments {

// Each brake takes its part of the desired force, or none if it would have to drive:
//
//     t_i = (E^T Fd)_i  if  s_i (E^T Fd)_i <= 0,   else 0.
//
// This is Fd itself in passive region I. Otherwise the brakes that move the handle into the wall are held and
// the others released. The remaining motion, v = sum_i E e_i w_i over the latter, has n . v >= 0: a pushing
// hand is led out of the wall, even if no force of the cone has a component along Fd. Of several contacts
// each brake takes the maximum part.
//
// For as many brakes as joints. Uses only the state. Cost: E^T n per contact.
//
// Reference: Cho, Song, Kim, Design and control of a planar haptic device with passive actuators based on
// passive force manipulability ellipsoid (FME) analysis, J. Robotic Systems 22 (9), 2005, 475-486 (its
// abstract). Assumed: the holding torque (the brake's part of Fd, so that stiff walls lock it); each brake is
// judged separately, in any dimension; the rates are those of the device, also at moving walls.
struct coercive_force_approximation {
  static constexpr bool commands_torques = true;  // A TorqueLaw.

  // Brake torques [N m].
  template <class M, class EMatrix, int D, int Capacity, class B>
  ph::brake_vector<M> torque(const ph::brake_situation<M, EMatrix, B>& device,
                             const ph::contacts<D, Capacity>& touched) const noexcept {
    using T = typename M::scalar;
    static_assert(M::brake_count == M::dof, "coercive_force_approximation needs brake_count == dof");
    ph::brake_vector<M> held = ph::brake_vector<M>::Zero();
    for (const auto& c : touched) {
      const auto Fd = ph::desired_force_of<T>(c);
      const ph::brake_vector<M> t = ph::brake_torque(device.E, Fd.direction);
      ph::unrolled<M::brake_count>([&](auto i) {
        const bool drives = device.s[i] * t[i] > T(0);
        if (!drives) held[i] = std::max(held[i], std::abs(t[i]) * Fd.magnitude);
      });
    }
    ph::unrolled<M::brake_count>([&](auto i) {
      held[i] = holding_torque(device.s[i], std::min(held[i], ph::torque_limit_of<T>(device.brakes, i)));
    });
    return held;
  }
};

}  // namespace experiments
