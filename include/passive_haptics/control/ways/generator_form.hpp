/// @file
/// Step 1 of section 4 for devices whose forces are those of generators: other than n brakes where
/// n = d, inertial forces.
#pragma once

#include <passive_haptics/brake/force_generators.hpp>
#include <passive_haptics/control/ways/one_wall.hpp>
#include <passive_haptics/force/torques/generator_form.hpp>

#include <type_traits>

namespace passive_haptics {

/// By generators, with torques of least norm.
template <displays_by_generators M>
struct display_form<M> {
  /// Fc for a desired force of 1 N. Needs no start.
  template <class Device, class T, int D>
  static auto nearest(const Device& device, const desired_force<T, D>& Fd, T min_cosine,
                      approximation_start&) {
    const auto G = passive_haptics::generators_of(device.pose);
    if constexpr (detail::names_torque_interval<std::remove_cvref_t<decltype(device.brakes)>>)
      return approximate_by_generators(G, passive_haptics::unbounded_torque_box_of(device.s, device.brakes),
                                       Fd.direction, min_cosine);
    else return approximate_by_generators(G, device.s, Fd.direction, min_cosine);
  }
};

}  // namespace passive_haptics
