/// @file
/// Generators of the displayable forces, for devices whose cone has no half-space form.
#pragma once

#include <passive_haptics/brake/brake_jacobian.hpp>
#include <passive_haptics/core/linear/cholesky.hpp>
#include <passive_haptics/core/linear/orthogonal_decomposition.hpp>
#include <passive_haptics/mechanism/dynamics.hpp>

#include <limits>

namespace passive_haptics {

namespace detail {
template <class M>
concept has_inverse_jacobian = requires(const M mechanism, const joint_vector<M> q) {
  { mechanism.inverse_jacobian(q) } -> ExactMatrix<typename M::scalar, M::dof, M::task_dimension>;
};
}  // namespace detail

/// G = J^-T T^T (d x m) [N per N m] for n = d: brake torques t make the force F = G t at the end effector,
/// however many brakes there are. From inverse_jacobian where the mechanism has one (closed chains). Not
/// finite at a singular J. Cost: one orthogonal decomposition of d x d.
template <class M>
  requires(M::dof == M::task_dimension)
matrix<typename M::scalar, M::task_dimension, M::brake_count> force_generators(const M& mechanism,
                                                                               const joint_vector<M>& q) {
  using T = typename M::scalar;
  using generators = matrix<T, M::task_dimension, M::brake_count>;
  matrix<T, M::brake_count, M::dof> A = matrix<T, M::brake_count, M::dof>::Identity();
  if constexpr (detail::has_exact_transmission<M>)
    A = matrix<T, M::brake_count, M::dof>(transmission(mechanism, q));
  if constexpr (detail::has_inverse_jacobian<M>) {
    return transposed(matrix<T, M::brake_count, M::task_dimension>(A * mechanism.inverse_jacobian(q)));
  } else {
    const auto Jt = transposed(matrix<T, M::dof, M::dof>(jacobian(mechanism, q)));
    const orthogonal_decomposition<T, M::dof, M::dof> decomposition(Jt, T(0));
    generators G = generators::Constant(std::numeric_limits<T>::quiet_NaN());
    if (decomposition.rank() < M::dof) return G;
    for (int i = 0; i < M::brake_count; ++i) G.col(i) = decomposition.solve(A.row(i).transpose());
    return G;
  }
}

/// G = Lambda J M^-1 T^T (d x m) [N per N m] for a device with self-motion (n > d): the force at the end
/// effector that accelerates it as the brake torques t do, with Lambda = (J M^-1 J^T)^-1 the task inertia.
/// The brakes may drive the self-motion meanwhile: it is the power t . w of the joints, not F . v, that is
/// never positive. Not finite at a singular J. Cost: a Cholesky of n x n and an orthogonal decomposition of n
/// x d. Reference: Khatib, A unified approach for motion and force control, IEEE J. Robotics and Automation 3
/// (1), 1987.
template <class M>
  requires(M::dof > M::task_dimension && Dynamics<M>)
matrix<typename M::scalar, M::task_dimension, M::brake_count> inertial_force_generators(
    const M& mechanism, const joint_vector<M>& q) {
  using T = typename M::scalar;
  const matrix<T, M::task_dimension, M::dof> J(jacobian(mechanism, q));
  matrix<T, M::dof, M::brake_count> Tt = matrix<T, M::dof, M::brake_count>::Identity();
  if constexpr (detail::has_exact_transmission<M>) {
    Tt = transposed(matrix<T, M::brake_count, M::dof>(transmission(mechanism, q)));
  }
  // M = L L^T and L^-1 J^T = Q R: Lambda J M^-1 T^T = (R^T R)^-1 R^T Q^T L^-1 T^T, a least-squares solution.
  const cholesky<T, M::dof> mass(mechanism.mass_matrix(q));
  const matrix<T, M::dof, M::task_dimension> A = mass.half_solve(transposed(J));
  const matrix<T, M::dof, M::brake_count> B = mass.half_solve(Tt);
  const orthogonal_decomposition<T, M::dof, M::task_dimension> decomposition(A, T(0));
  using generators = matrix<T, M::task_dimension, M::brake_count>;
  generators G = generators::Constant(std::numeric_limits<T>::quiet_NaN());
  if (decomposition.rank() < M::task_dimension) return G;
  for (int i = 0; i < M::brake_count; ++i) G.col(i) = decomposition.solve(B.col(i));
  return G;
}

}  // namespace passive_haptics
