/// @file
/// Step 1 of section 4 for devices whose forces are those of generators: other than n brakes where
/// n = d, inertial forces.
#pragma once

#include <passive_haptics/brake/force_generators.hpp>
#include <passive_haptics/control/ways/one_wall.hpp>
#include <passive_haptics/force/torques/generator_form.hpp>

namespace passive_haptics {

/// By generators, with torques of least norm in the units of the brakes' limits
/// (force/torques/torque_units.hpp).
template <displays_by_generators M>
struct display_form<M> {
  /// Fc for a desired force of 1 N. Needs no start.
  template <class Device, class T, int D>
  static auto nearest(const Device& device, const desired_force<T, D>& Fd, T min_cosine,
                      approximation_start&) {
    return approximate_by_generators(passive_haptics::generators_of(device.pose), device.s, Fd.direction,
                                     min_cosine,
                                     passive_haptics::torque_units_of<M>(device.s, device.brakes));
  }
};

}  // namespace passive_haptics
