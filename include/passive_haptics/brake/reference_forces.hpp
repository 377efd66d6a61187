/// @file
/// Reference forces: what each brake alone does at the end effector (4)-(6).
#pragma once

#include <passive_haptics/brake/brake_jacobian.hpp>
#include <passive_haptics/core/linear/orthogonal_decomposition.hpp>
#include <passive_haptics/core/status.hpp>

#include <limits>

namespace passive_haptics {

/// Reference forces of all brakes at one pose.
template <class M>
struct reference_force_set {
  /// G = J^-T T^T (d x m) [N per N m]: R_i+ is column i, R_i- its negative. NaN unless outcome is ok.
  matrix<typename M::scalar, M::task_dimension, M::brake_count> G;
  status outcome = status::ok;  ///< ok, pose_undefined, or singular_jacobian.
};

/// G = E^-T, the forces (4) for unit torque of one brake with the others released. For n = d.
/// For looking at the device (passive FME): the control step never needs this inverse. Cost: one
/// decomposition of d x d.
template <class M>
  requires(M::dof == M::task_dimension && M::brake_count == M::dof)
reference_force_set<M> reference_forces(const M& mechanism, const joint_vector<M>& q) {
  using T = typename M::scalar;
  constexpr int d = M::task_dimension;
  using square = matrix<T, d, d>;
  const square E = square(brake_jacobian(mechanism, q));
  const square none = square::Constant(std::numeric_limits<T>::quiet_NaN());
  if (!all_finite(E)) return {none, status::pose_undefined};
  const orthogonal_decomposition<T, d, d> Et(transposed(E), rounding_tolerance<T>(d));
  if (Et.rank() < d) return {none, status::singular_jacobian};
  return {Et.pseudo_inverse(), status::ok};
}

}  // namespace passive_haptics
