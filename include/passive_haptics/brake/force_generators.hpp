/// Generators of the forces that brakes can produce.
#pragma once

#include <passive_haptics/core/linear/orthogonal_decomposition.hpp>
#include <passive_haptics/mechanism/jacobian.hpp>

#include <concepts>
#include <limits>

namespace passive_haptics {

namespace detail {
template <class M>
concept has_inverse_jacobian = requires(const M mechanism, const joint_vector<M> q) {
  { mechanism.inverse_jacobian(q) } -> ExactMatrix<typename M::scalar, M::dof, M::task_dimension>;
};
template <class M>
concept has_inverse_transposed_jacobian = requires(const M mechanism, const joint_vector<M> q) {
  { mechanism.inverse_transposed_jacobian(q) } -> ExactMatrix<typename M::scalar, M::task_dimension, M::dof>;
};
// For a mechanism behind virtual functions (runtime/mechanism_of_kind.hpp).
template <class M>
concept has_force_generators = requires(const mechanism_pose<M>& pose) {
  { pose.mechanism().force_generators(pose.own()) } -> std::same_as<brake_matrix<M>>;
};
}  // namespace detail

/// Forces of brake torques, F = J^-T t with joint torques t, for n = d.
/// @equation{4}
///
/// G = J^-T T^T (d x m) [N per N m], one column per brake. Uses inverse_transposed_jacobian or
/// inverse_jacobian if the mechanism has it. Not finite if J is singular. Cost: a d x d decomposition.
template <class M>
  requires(M::dof == M::task_dimension)
brake_matrix<M> force_generators(const mechanism_pose<M>& pose) {
  using T = typename M::scalar;
  const M& mechanism = pose.mechanism();
  if constexpr (detail::has_force_generators<M>) {
    return mechanism.force_generators(pose.own());
  } else {
    const matrix<T, M::dof, M::brake_count> Tt = pose.transposed_transmission();
    if constexpr (detail::has_inverse_transposed_jacobian<M>) {
      return mechanism.inverse_transposed_jacobian(pose.q()) * Tt;
    } else if constexpr (detail::has_inverse_jacobian<M>) {
      return transposed(mechanism.inverse_jacobian(pose.q())) * Tt;
    } else {
      const auto Jt = transposed(matrix<T, M::dof, M::dof>(pose.jacobian()));
      const orthogonal_decomposition<T, M::dof, M::dof> decomposition(Jt, T(0));
      if (decomposition.rank() == M::dof) return decomposition.solve(Tt);
      return brake_matrix<M>::Constant(std::numeric_limits<T>::quiet_NaN());
    }
  }
}

/// G (4) in pose q.
template <class M>
  requires(M::dof == M::task_dimension)
brake_matrix<M> force_generators(const M& mechanism, const joint_vector<M>& q) {
  return passive_haptics::force_generators(mechanism_pose<M>(mechanism, q));
}

}  // namespace passive_haptics
