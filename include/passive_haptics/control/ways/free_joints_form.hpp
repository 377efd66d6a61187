/// @file
/// Step 1 of section 4 for devices with self-motion and fewer brakes than joints, kinetostatically.
#pragma once

#include <passive_haptics/control/ways/one_wall.hpp>
#include <passive_haptics/force/torques/free_joints.hpp>

namespace passive_haptics {

/// By half-spaces, within the forces that leave joints without a brake alone.
template <leaves_free_joints_alone M>
struct display_form<M> {
  /// Fc for a desired force of 1 N. Needs no start.
  template <class Device, class T, int D>
  static auto nearest(const Device& device, const desired_force<T, D>& Fd, T min_cosine,
                      approximation_start&) {
    return approximate_within(passive_haptics::forces_of_braked_joints(device.pose),
                              brake_matrix<M>(device.E), device.s, Fd.direction, min_cosine,
                              passive_haptics::brakes_off(device.s, device.brakes));
  }
};

}  // namespace passive_haptics
