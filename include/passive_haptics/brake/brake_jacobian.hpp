/// @file
/// E = J T^+, which maps brake rates to end-effector velocity and forces to brake torques.
#pragma once

#include <passive_haptics/core/linear/orthogonal_decomposition.hpp>
#include <passive_haptics/mechanism/jacobian.hpp>

#include <limits>
#include <utility>

namespace passive_haptics {

/// Brake torques t = E^T F [N m] that balance the force F [N] at the end effector.
///
/// @equation{2}
template <class T, int D, int Brakes>
vector<T, Brakes> brake_torque(const matrix<T, D, Brakes>& E, const vector<T, D>& F) {
  return transposed_times(E, F);
}

/// t = E^T F [N m] of a diagonal E.
template <class T, int D>
vector<T, D> brake_torque(const diagonal_matrix<T, D>& E, const vector<T, D>& F) {
  return E * F;
}

/// T^+ (n x m) of a transmission T (m x n): T^-1 for square T, (T^T T)^-1 T^T for redundant brakes, T^T (T
/// T^T)^-1 for fewer brakes than joints. NaN where T has not full rank. Cost: one orthogonal decomposition of
/// n x m.
template <class T, int Brakes, int Dof>
matrix<T, Dof, Brakes> pseudo_inverse(const matrix<T, Brakes, Dof>& transmission) {
  const orthogonal_decomposition<T, Dof, Brakes> decomposition(transposed(transmission), T(0));
  if (decomposition.rank() == (Brakes < Dof ? Brakes : Dof))
    return transposed(decomposition.pseudo_inverse());
  return matrix<T, Dof, Brakes>::Constant(std::numeric_limits<T>::quiet_NaN());
}

/// T^+ of a diagonal transmission, entry by entry.
template <class T, int N>
diagonal_matrix<T, N> pseudo_inverse(const diagonal_matrix<T, N>& transmission) {
  return diagonal_matrix<T, N>(transmission.diagonal().cwiseInverse());
}

/// From J to E for one mechanism: T^+ where the mechanism names a transmission, made once if T is constant.
template <class M>
class brake_jacobian_evaluator {
 public:
  /// Of the mechanism.
  explicit brake_jacobian_evaluator(const M& mechanism) : inverse_(inverse_of_constant(mechanism)) {}

  /// E = J T^+. A diagonal_matrix where J and T are; J itself where there is no transmission.
  auto operator()(const mechanism_pose<M>& pose) const {
    if constexpr (!detail::has_exact_transmission<M>) return pose.jacobian();
    else if constexpr (is_constant) return times(pose.jacobian(), inverse_);
    else return times(pose.jacobian(), pseudo_inverse(pose.transmission()));
  }

 private:
  using T = typename M::scalar;
  static constexpr bool is_constant = detail::transmission_is_constant<M>;
  struct nothing {};

  template <class JMatrix, class Inverse>
  static auto times(const JMatrix& J, const Inverse& inverse) {
    constexpr bool diagonal_J = ExactDiagonal<JMatrix, T, M::dof>,
                   diagonal_T = ExactDiagonal<Inverse, T, M::dof>;
    if constexpr (diagonal_J && diagonal_T)
      return diagonal_matrix<T, M::dof>(J.diagonal().cwiseProduct(inverse.diagonal()));
    else return brake_matrix<M>(passive_haptics::times(J, inverse));
  }

  static auto inverse_of_constant(const M& mechanism) {
    if constexpr (is_constant) return pseudo_inverse(mechanism.transmission());
    else return nothing{};
  }
  [[no_unique_address]] decltype(inverse_of_constant(std::declval<const M&>())) inverse_;
};

/// E = J T^+ (d x m, base frame), T^+ = T^-1 for square T: v = E w and, by virtual work, t = E^T F balances
/// F. Needs no inverse of J, which may be singular. For redundant brakes T^+ = (T^T T)^-1 T^T, so t = E^T F
/// has the least norm of all torques that balance F. For fewer brakes than joints T^+ = T^T (T
/// T^T)^-1: then v = E w holds while joints without a brake rest, and t = E^T F balances those F that leave
/// these joints without torque.
///
/// A diagonal_matrix where J and T are; J itself where the mechanism names no transmission. Not finite where
/// J is undefined or T singular. Cost: T^+ and a product; a loop keeps a brake_jacobian_evaluator instead.
template <class M>
auto brake_jacobian(const M& mechanism, const joint_vector<M>& q) {
  return brake_jacobian_evaluator<M>(mechanism)(mechanism_pose<M>(mechanism, q));
}

}  // namespace passive_haptics
