/// @file
/// E = J T^+, which maps brake rates to end-effector velocity and forces to brake torques.
#pragma once

#include <passive_haptics/core/orthogonal_decomposition.hpp>
#include <passive_haptics/mechanism/jacobian.hpp>

#include <limits>

namespace passive_haptics {

/// E = J T^+ (d x m, base frame), T^+ = T^-1 for square T: v = E w and, by virtual work, t = E^T F balances F.
/// Needs no inverse of J, which may be singular. For redundant brakes T^+ = (T^T T)^-1 T^T, so t = E^T F has the
/// least norm of all torques that balance F.
///
/// A diagonal_matrix where J and T are; J itself where the mechanism names no transmission. Not finite where
/// J is undefined or T singular. Cost for a dense T: one orthogonal decomposition of n x m.
template <class M>
auto brake_jacobian(const M& mechanism, const joint_vector<M>& q) {
  using T = typename M::scalar;
  const auto J = jacobian(mechanism, q);
  if constexpr (!detail::has_exact_transmission<M>) {
    return J;
  } else {
    using dense = matrix<T, M::task_dimension, M::brake_count>;
    const auto A = transmission(mechanism, q);
    constexpr bool diagonal_J = ExactDiagonal<decltype(J), T, M::dof>;
    constexpr bool diagonal_T = ExactDiagonal<decltype(A), T, M::dof>;
    if constexpr (diagonal_J && diagonal_T) {
      return diagonal_matrix<T, M::dof>(J.diagonal().cwiseQuotient(A.diagonal()));
    } else if constexpr (diagonal_T) {
      return dense(J.array().rowwise() / A.diagonal().transpose().array());
    } else {  // E T = J, so each row e of E is the shortest solution of T^T e = j
      const auto Tt = transposed(matrix<T, M::brake_count, M::dof>(A));
      const matrix<T, M::task_dimension, M::dof> full_J(J);
      const orthogonal_decomposition<T, M::dof, M::brake_count> decomposition(Tt, T(0));
      dense E = dense::Constant(std::numeric_limits<T>::quiet_NaN());
      if (decomposition.rank() < M::dof) return E;
      for (int i = 0; i < M::task_dimension; ++i) E.row(i) = decomposition.solve(full_J.row(i).transpose());
      return E;
    }
  }
}

/// Brake torques t = E^T F [N m] that balance the force F [N] at the end effector.
template <class T, int D, int Brakes>
vector<T, Brakes> brake_torque(const matrix<T, D, Brakes>& E, const vector<T, D>& F) {
  return E.transpose() * F;
}

/// The same for a diagonal E.
template <class T, int D>
vector<T, D> brake_torque(const diagonal_matrix<T, D>& E, const vector<T, D>& F) {
  return E.diagonal().cwiseProduct(F);
}

}  // namespace passive_haptics
