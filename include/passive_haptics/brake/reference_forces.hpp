/// Reference forces: the force of each brake at the end effector (6).
#pragma once

#include <passive_haptics/brake/brake_jacobian.hpp>
#include <passive_haptics/brake/force_generators.hpp>
#include <passive_haptics/core/finite.hpp>
#include <passive_haptics/core/status.hpp>

#include <limits>

namespace passive_haptics {

/// Reference forces of all brakes in one pose.
template <class M>
struct reference_force_set {
  brake_matrix<M> G;            ///< Forces (4) of unit torques (d x m) [N per N m]. NaN unless outcome is ok.
  status outcome = status::ok;  ///< ok, pose_undefined, or singular_jacobian.

  /// R_i+ [N per N m], the force of brake i for a unit torque > 0. Brakes are counted from 0.
  /// @equation{6}
  task_vector<M> positive(int i) const { return G.col(i); }
  task_vector<M> negative(int i) const { return -G.col(i); }  ///< R_i- [N per N m], for a torque < 0.
};

/// Reference forces in pose q, for n = d = m, for analysis of a device. Cost: two d x d decompositions.
template <class M>
  requires(M::dof == M::task_dimension && M::brake_count == M::dof)
reference_force_set<M> reference_forces(const M& mechanism, const joint_vector<M>& q) {
  using T = typename M::scalar;
  constexpr int d = M::task_dimension;
  using square = matrix<T, d, d>;
  const square E(passive_haptics::brake_jacobian(mechanism, q));
  const square none = square::Constant(std::numeric_limits<T>::quiet_NaN());
  if (!all_finite(E)) return {none, status::pose_undefined};
  if (orthogonal_decomposition<T, d, d>(transposed(E), rounding_tolerance<T>(d)).rank() < d)
    return {none, status::singular_jacobian};
  return {passive_haptics::force_generators(mechanism, q), status::ok};
}

}  // namespace passive_haptics
