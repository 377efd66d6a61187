/// @file
/// Step 1 of section 4 for devices whose forces are those of generators: redundant brakes, inertial forces.
#pragma once

#include <passive_haptics/brake/force_generators.hpp>
#include <passive_haptics/control/ways/one_wall.hpp>
#include <passive_haptics/force/torques/generator_form.hpp>

#include <type_traits>

namespace passive_haptics {

/// Fc for a unit desired force n by generators, with torques of least norm.
template <displays_by_generators M>
struct approximation_for<M> {
  /// Needs no start.
  template <class Device>
  static auto of(const Device& device, const task_vector<M>& n, typename M::scalar min_cosine,
                 half_space_start&) {
    const auto G = passive_haptics::generators_of(device.pose);
    if constexpr (detail::names_torque_interval<std::remove_cvref_t<decltype(device.brakes)>>)
      return approximate_by_generators(G, passive_haptics::unbounded_torque_box_of(device.s, device.brakes),
                                       n, min_cosine);
    else return approximate_by_generators(G, device.s, n, min_cosine);
  }
};

}  // namespace passive_haptics
