/// E = J T^+, from brake rates to end-effector velocity and from forces to brake torques.
#pragma once

#include <passive_haptics/core/linear/orthogonal_decomposition.hpp>
#include <passive_haptics/mechanism/jacobian.hpp>

#include <limits>
#include <utility>

namespace passive_haptics {

/// Brake torques t = E^T F [N m] that balance the force F [N] at the end effector.
/// @equation{2}
template <class T, int D, int Brakes>
vector<T, Brakes> brake_torque(const matrix<T, D, Brakes>& E, const vector<T, D>& F) {
  return transposed_times(E, F);
}

/// As above, for a diagonal E.
template <class T, int D>
vector<T, D> brake_torque(const diagonal_matrix<T, D>& E, const vector<T, D>& F) {
  return E * F;
}

/// T^+ (n x m) of a transmission T (m x n): T^-1 for square T, (T^T T)^-1 T^T for redundant brakes, T^T (T
/// T^T)^-1 for fewer brakes than joints. NaN if T does not have full rank. Cost: an n x m decomposition.
template <class T, int Brakes, int Dof>
matrix<T, Dof, Brakes> pseudo_inverse(const matrix<T, Brakes, Dof>& transmission) {
  const orthogonal_decomposition<T, Dof, Brakes> decomposition(transposed(transmission), T(0));
  if (decomposition.rank() == (Brakes < Dof ? Brakes : Dof))
    return transposed(decomposition.pseudo_inverse());
  return matrix<T, Dof, Brakes>::Constant(std::numeric_limits<T>::quiet_NaN());
}

/// As above, for a diagonal transmission.
template <class T, int N>
diagonal_matrix<T, N> pseudo_inverse(const diagonal_matrix<T, N>& transmission) {
  return diagonal_matrix<T, N>(transmission.diagonal().cwiseInverse());
}

/// Converts J to E for one mechanism. If T is constant, T^+ is computed only once.
template <class M>
class brake_jacobian_evaluator {
 public:
  /// Prepares E for this mechanism.
  explicit brake_jacobian_evaluator(const M& mechanism) : inverse_(inverse_of_constant(mechanism)) {}

  /// E = J T^+. A diagonal_matrix if J and T are; J itself without a transmission.
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

/// E = J T^+ (d x m, base frame): v = E w and, by virtual work, t = E^T F balances F. J may be singular. T^+
/// is T^-1 for square T. For redundant brakes T^+ = (T^T T)^-1 T^T, so t has the least norm of all torques
/// that balance F. For fewer brakes than joints T^+ = T^T (T T^T)^-1: v = E w holds while the joints without
/// a brake are at rest, and t balances forces F without torque on these joints. A diagonal_matrix if J and T
/// are; J itself without a transmission. Not finite if J is undefined or T singular. Cost: T^+ and a product;
/// in a loop, use a brake_jacobian_evaluator.
template <class M>
auto brake_jacobian(const M& mechanism, const joint_vector<M>& q) {
  return brake_jacobian_evaluator<M>(mechanism)(mechanism_pose<M>(mechanism, q));
}

}  // namespace passive_haptics
