/// @file
/// Step 1 of a cycle for devices whose forces are told by generators: redundant brakes, and inertial forces.
#pragma once

#include <passive_haptics/control/extensions/force_map.hpp>
#include <passive_haptics/control/stages.hpp>
#include <passive_haptics/force/torques/generator_form.hpp>

namespace passive_haptics {

/// Fc: Fd itself, or the nearest force that the brakes can make with Fc . n = |Fd|, by torques of least norm.
template <displays_by_generators M, class B, ScalingLaw L, class Now, class T, int D>
approximated_force<T, D, M::brake_count> displayed(const cycle_parts<M, B, L>& with, const Now& now,
                                                   const desired_force<T, D>& Fd, const auto& /*touched*/,
                                                   step_memory<L>&) {
  const auto G = generators_of(now.mechanism, now.q);
  return Fd.magnitude * approximate_by_generators(G, now.s, Fd.direction, with.options.min_cosine);
}

}  // namespace passive_haptics
