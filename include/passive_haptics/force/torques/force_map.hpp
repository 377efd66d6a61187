/// @file
/// The forces that torques make, in the form that fits the mechanism.
#pragma once

#include <passive_haptics/brake/at_rest/settled_rates.hpp>
#include <passive_haptics/brake/brake_jacobian.hpp>
#include <passive_haptics/brake/force_generators.hpp>
#include <passive_haptics/force/torques/contact_forces.hpp>

namespace passive_haptics {

/// F = G t of a device with self-motion.
template <class M>
force_map<typename M::scalar, M::task_dimension, M::brake_count> force_map_of(const settled_rates<M>& rates) {
  constexpr int m = M::brake_count, rows = m < M::dof ? m : M::dof;
  force_map<typename M::scalar, M::task_dimension, m> map{rates.least_rates().transpose()};
  map.P.template topRows<rows>() = rates.of_self_motion().transpose().template topRows<rows>();
  return map;
}

/// F = G t in the form that fits the mechanism, E from brake_jacobian.
///
/// Of a device whose self-motion settles, or with fewer brakes than joints, F = (T J^+)^T t of torques that
/// leave the self-motion alone, (T N)^T t = 0; where it settles, which signs they may have depends on S
/// (force/torques/settled_approximation.hpp).
template <class M, class EMatrix>
auto force_map_of(const mechanism_pose<M>& pose, const EMatrix& E) {
  if constexpr (displays_by_generators<M>)
    return force_map<typename M::scalar, M::task_dimension, M::brake_count>{
        passive_haptics::generators_of(pose)};
  else if constexpr (Settles<M> || leaves_free_joints_alone<M>)
    return passive_haptics::force_map_of(settled_rates<M>(pose));
  else return invert_brake_jacobian(brake_matrix<M>(E));
}

/// F = G t in pose q.
template <class M>
auto force_map_of(const M& mechanism, const joint_vector<M>& q) {
  static_assert(has_known_forces<M, explain>());
  return passive_haptics::force_map_of(mechanism_pose<M>(mechanism, q),
                                       passive_haptics::brake_jacobian(mechanism, q));
}

}  // namespace passive_haptics
