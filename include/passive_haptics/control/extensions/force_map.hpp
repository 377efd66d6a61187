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

/// F = G t in the form that fits the mechanism, E from brake_jacobian.
template <class M, class EMatrix>
auto force_map_of(const M& mechanism, const joint_vector<M>& q, const EMatrix& E) {
  if constexpr (displays_by_generators<M>)
    return force_map<typename M::scalar, M::task_dimension, M::brake_count>{generators_of(mechanism, q)};
  else return invert_brake_jacobian(brake_matrix<M>(E));
}

/// The same in pose q.
template <class M>
auto force_map_of(const M& mechanism, const joint_vector<M>& q) {
  static_assert(mechanism_requirements<M>::met && self_motion_requirements<M>::met);
  return force_map_of(mechanism, q, brake_jacobian(mechanism, q));
}

/// The same in a control cycle.
template <class M, class EMatrix, class B>
auto force_map_of(const brake_situation<M, EMatrix, B>& now) {
  return force_map_of(now.mechanism, now.q, now.E);
}

}  // namespace passive_haptics
