/// @file
/// The Jacobian and the transmission of any mechanism, from whatever the mechanism gives.
#pragma once

#include <passive_haptics/core/linear/lane_products.hpp>
#include <passive_haptics/core/scalar/dual_number.hpp>
#include <passive_haptics/mechanism/mechanism.hpp>

namespace passive_haptics {
namespace detail {

template <class M>
using derivative_scalar = dual_number<typename M::scalar, M::dof>;

template <class M>
concept differentiates_itself =
    names_sizes<M> && requires(const M mechanism, const vector<derivative_scalar<M>, M::dof> q) {
      { mechanism.position(q) } -> ExactVector<derivative_scalar<M>, M::task_dimension>;
    };

}  // namespace detail

/// A mechanism with a Jacobian: it gives one, or its position is a template over the scalar.
template <class M>
concept DifferentiableMechanism =
    Mechanism<M> && (detail::has_exact_jacobian<M> || detail::differentiates_itself<M>);

/// J (d x n) by forward-mode automatic differentiation of position(q); exact to rounding.
/// Cost: one position with n derivatives carried along.
template <class M>
jacobian_matrix<M> automatic_jacobian(const M& mechanism, const joint_vector<M>& q) {
  using scalar = detail::derivative_scalar<M>;
  vector<scalar, M::dof> seeded;
  for (int i = 0; i < M::dof; ++i) seeded[i] = scalar::variable(q[i], i);
  const vector<scalar, M::task_dimension> x = mechanism.position(seeded);
  jacobian_matrix<M> J;
  for (int i = 0; i < M::task_dimension; ++i) J.row(i) = x[i].derivatives();
  return J;
}

/// J in v = J qd, d x n, base frame [m/rad or 1]: a matrix, or a diagonal_matrix where the mechanism says so.
template <class M>
auto jacobian(const M& mechanism, const joint_vector<M>& q) {
  static_assert(mechanism_requirements<M>::met);
  static_assert(DifferentiableMechanism<M>,
                "passive_haptics: the mechanism needs jacobian(q), or position(q) templated on the scalar "
                "(`template <class S> vector<S, d> position(const vector<S, n>& q) const`).");
  if constexpr (detail::jacobian_is_constant<M>) return mechanism.jacobian();
  else if constexpr (detail::jacobian_depends_on_pose<M>) return mechanism.jacobian(q);
  else return automatic_jacobian(mechanism, q);
}

/// What position and Jacobian have in common: mechanism.pose(q), or q itself where there is none.
template <class M>
auto pose(const M& mechanism, const joint_vector<M>& q) {
  if constexpr (detail::has_pose<M>) return mechanism.pose(q);
  else return q;
}

/// J in a pose from pose(mechanism, q).
template <class M, class Pose>
  requires(!std::same_as<Pose, joint_vector<M>>)
auto jacobian(const M& mechanism, const Pose& at) {
  return mechanism.jacobian(at);
}

/// T in w = T qd, m x n: a matrix or a diagonal_matrix. Only for mechanisms that name a transmission.
template <class M>
  requires detail::has_exact_transmission<M>
auto transmission(const M& mechanism, const joint_vector<M>& q) {
  if constexpr (detail::transmission_is_constant<M>) return mechanism.transmission();
  else return mechanism.transmission(q);
}

/// T^T (n x m), which makes joint torques of brake torques; the identity for a mechanism that names no
/// transmission.
template <class M>
matrix<typename M::scalar, M::dof, M::brake_count> transposed_transmission(const M& mechanism,
                                                                           const joint_vector<M>& q) {
  using T = typename M::scalar;
  if constexpr (detail::has_exact_transmission<M>)
    return transposed(transmission_matrix<M>(transmission(mechanism, q)));
  else return matrix<T, M::dof, M::brake_count>::Identity();
}

/// Velocity of the end effector, v = J qd [m/s], base frame.
template <class M>
task_vector<M> velocity(const M& mechanism, const joint_vector<M>& q, const joint_vector<M>& qd) {
  return times(jacobian(mechanism, q), qd);
}

/// Rates of the brakes' axes, w = T qd [rad/s or m/s].
template <class M>
brake_vector<M> brake_rates(const M& mechanism, const joint_vector<M>& q, const joint_vector<M>& qd) {
  if constexpr (detail::has_exact_transmission<M>) return times(transmission(mechanism, q), qd);
  else return as<typename M::scalar>(qd);  // entry by entry: a packet would go through memory
}

}  // namespace passive_haptics
