/// @file
/// E = J T^-1, which maps brake rates to end-effector velocity and forces to brake torques.
#pragma once

#include <passive_haptics/mechanism/jacobian.hpp>

#include <Eigen/LU>

namespace passive_haptics {

/// E = J T^-1 (d x m, base frame): E e_i is the end-effector velocity for unit rate of brake i, so
/// v = E w and, by virtual work, t = E^T F. Needs no inverse of J, which may be singular.
///
/// A diagonal_matrix where J and T are; J itself where the mechanism names no transmission. Not finite where
/// J is undefined or T singular. Cost for a dense T: one LU of m x m.
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
    } else {  // E T = J, so each row e of E solves T^T e = j
      const Eigen::PartialPivLU<matrix<T, M::dof, M::dof>> lu(A);
      const matrix<T, M::task_dimension, M::dof> full(J);
      dense E;
      for (int i = 0; i < M::task_dimension; ++i) {
        E.row(i) = lu.transpose().solve(vector<T, M::dof>(full.row(i)));
      }
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
