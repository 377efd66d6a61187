// The brakes that move into the wall are held, so that the remaining motion leads out.
#pragma once

#include "intended_rates.hpp"

#include <algorithm>
#include <cmath>

namespace experiments {

// Each brake takes its own part of the desired force, or none where it would have to drive:
//
//     t_i = (E^T Fd)_i  if  s_i (E^T Fd)_i <= 0,   else 0.
//
// That is Fd itself in passive region I. Elsewhere the brakes that move the handle into the wall are held
// and the others let go, so that the motion that is left, v = sum_i E e_i w_i over the latter, has n . v >=
// 0: a hand that pushes on is led out of the wall, also where no force of the cone has a component along Fd
// and an approximation displays nothing. Of several contacts each brake takes the largest of its parts.
//
// For as many brakes as joints. Needs nothing but the state; cost: E^T n for each contact.
//
// Reference: Cho, Song, Kim, Design and control of a planar haptic device with passive actuators based on
// passive force manipulability ellipsoid (FME) analysis, J. Robotic Systems 22 (9), 2005, 475-486 (its
// abstract). Assumed: how hard a brake is held (its part of Fd, so that stiff walls lock it); every brake is
// judged alone, which makes it the same in any dimension; the rates are those of the device, also at moving
// walls.
struct coercive_force_approximation {
  static constexpr bool commands_torques = true;  // It is a TorqueLaw.

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
