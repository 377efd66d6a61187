/// @file
/// The forces that torques make, in the form that fits the mechanism.
#pragma once

#include <passive_haptics/brake/force_generators.hpp>
#include <passive_haptics/control/control_law.hpp>
#include <passive_haptics/force/torques/contact_forces.hpp>

namespace passive_haptics {

/// G in F = G t of a device whose cone has no half-spaces: redundant brakes, and inertial forces.
template <displays_by_generators M>
auto generators_of(const M& mechanism, const joint_vector<M>& q) {
  if constexpr (has_inertial_forces<M>) return inertial_force_generators(mechanism, q);
  else return force_generators(mechanism, q);
}

/// F = G t in the form that fits the mechanism.
template <class M, class EMatrix, class B>
auto force_map_of(const brake_situation<M, EMatrix, B>& now) {
  using T = typename M::scalar;
  using map = force_map<T, M::task_dimension, M::brake_count>;
  if constexpr (displays_by_generators<M>) return map{generators_of(now.mechanism, now.q)};
  else return invert_brake_jacobian(matrix<T, M::task_dimension, M::brake_count>(now.E));
}

}  // namespace passive_haptics
