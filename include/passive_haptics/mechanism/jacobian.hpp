/// Jacobian and transmission of any mechanism.
#pragma once

#include <passive_haptics/core/flatten.hpp>
#include <passive_haptics/core/linear/lane_products.hpp>
#include <passive_haptics/core/scalar/dual_number.hpp>
#include <passive_haptics/mechanism/mechanism.hpp>

#include <utility>

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

/// Requirements of DifferentiableMechanism: `static_assert(is_differentiable_mechanism<M, explain>())`.
template <class M, bool Explain = false>
consteval bool is_differentiable_mechanism() {
  if constexpr (!Mechanism<M>) return is_mechanism<M, Explain>();
  else if constexpr (!detail::has_exact_jacobian<M> && !detail::differentiates_itself<M>)
    static_assert(!Explain,
                  "passive_haptics: the mechanism needs jacobian(q), or position(q) templated on the scalar "
                  "(`template <class S> vector<S, d> position(const vector<S, n>& q) const`).");
  else return true;
  return Explain;
}

/// A mechanism with a member jacobian, or a position that is a template over the scalar.
template <class M>
concept DifferentiableMechanism = Mechanism<M> && is_differentiable_mechanism<M>();

/// J (d x n) by forward-mode differentiation of position(q). Cost: one position with n derivatives.
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

/// A mechanism in one pose, with its pose(q) computed once. The mechanism and q must outlive this object.
template <class M>
class mechanism_pose {
  using T = typename M::scalar;

  PASSIVE_HAPTICS_PART static auto pose_of(const M& mechanism, const joint_vector<M>& q) {
    if constexpr (detail::has_pose<M>) return mechanism.pose(q);
    else return q;
  }

 public:
  /// The mechanism in pose q.
  PASSIVE_HAPTICS_PART mechanism_pose(const M& mechanism, const joint_vector<M>& q)
      : mechanism_(mechanism), q_(q), pose_(pose_of(mechanism, q)) {}
  mechanism_pose(const M&, const joint_vector<M>&&) = delete;  ///< Rejects a temporary q.

  task_vector<M> position() const { return mechanism_.position(pose_); }  ///< x [m], base frame.

  /// J in v = J qd, d x n, base frame [m/rad or 1]: a matrix or the mechanism's diagonal_matrix.
  auto jacobian() const {
    static_assert(is_differentiable_mechanism<M, explain>());
    if constexpr (detail::jacobian_is_constant<M>) return mechanism_.jacobian();
    else if constexpr (detail::jacobian_depends_on_pose<M>) return mechanism_.jacobian(pose_);
    else return passive_haptics::automatic_jacobian(mechanism_, q_);
  }

  /// T in w = T qd, m x n: a matrix or a diagonal_matrix. Requires a mechanism with a transmission.
  auto transmission() const {
    if constexpr (detail::transmission_is_constant<M>) return mechanism_.transmission();
    else if constexpr (requires { mechanism_.transmission(pose_); }) return mechanism_.transmission(pose_);
    else return mechanism_.transmission(q_);
  }

  /// T^T (n x m), from brake to joint torques; the identity without a transmission.
  matrix<T, M::dof, M::brake_count> transposed_transmission() const {
    if constexpr (detail::has_exact_transmission<M>)
      return transposed(transmission_matrix<M>(transmission()));
    else return matrix<T, M::dof, M::brake_count>::Identity();
  }

  /// End-effector velocity v = J qd [m/s], base frame.
  task_vector<M> velocity(const joint_vector<M>& qd) const { return times(jacobian(), qd); }

  /// Brake rates w = T qd [rad/s or m/s].
  brake_vector<M> brake_rates(const joint_vector<M>& qd) const {
    if constexpr (detail::has_exact_transmission<M>) return times(transmission(), qd);
    else return qd;
  }

  /// M [kg m^2, kg m or kg], for mechanisms with Dynamics.
  matrix<T, M::dof, M::dof> mass_matrix() const {
    if constexpr (requires { mechanism_.mass_matrix(pose_); }) return mechanism_.mass_matrix(pose_);
    else return mechanism_.mass_matrix(q_);
  }

  /// c [N m or N], for mechanisms with Dynamics.
  joint_vector<M> bias_torque(const joint_vector<M>& qd) const {
    if constexpr (requires { mechanism_.bias_torque(pose_, qd); }) return mechanism_.bias_torque(pose_, qd);
    else return mechanism_.bias_torque(q_, qd);
  }

  /// Jd qd [m/s^2], for mechanisms with Dynamics.
  task_vector<M> bias_acceleration(const joint_vector<M>& qd) const {
    if constexpr (requires { mechanism_.bias_acceleration(pose_, qd); })
      return mechanism_.bias_acceleration(pose_, qd);
    else return mechanism_.bias_acceleration(q_, qd);
  }

  const M& mechanism() const { return mechanism_; }  ///< The mechanism.
  const joint_vector<M>& q() const { return q_; }    ///< q [rad or m].
  const auto& own() const { return pose_; }          ///< The mechanism's pose(q), or q if it has none.

 private:
  const M& mechanism_;
  const joint_vector<M>& q_;
  decltype(pose_of(std::declval<const M&>(), std::declval<const joint_vector<M>&>())) pose_;
};

/// J in pose q.
template <class M>
auto jacobian(const M& mechanism, const joint_vector<M>& q) {
  return mechanism_pose<M>(mechanism, q).jacobian();
}

/// T in pose q.
template <class M>
  requires detail::has_exact_transmission<M>
auto transmission(const M& mechanism, const joint_vector<M>& q) {
  return mechanism_pose<M>(mechanism, q).transmission();
}

/// T^T in pose q.
template <class M>
matrix<typename M::scalar, M::dof, M::brake_count> transposed_transmission(const M& mechanism,
                                                                           const joint_vector<M>& q) {
  return mechanism_pose<M>(mechanism, q).transposed_transmission();
}

/// v = J qd [m/s] in pose q.
template <class M>
task_vector<M> velocity(const M& mechanism, const joint_vector<M>& q, const joint_vector<M>& qd) {
  return mechanism_pose<M>(mechanism, q).velocity(qd);
}

/// w = T qd [rad/s or m/s] in pose q.
template <class M>
brake_vector<M> brake_rates(const M& mechanism, const joint_vector<M>& q, const joint_vector<M>& qd) {
  return mechanism_pose<M>(mechanism, q).brake_rates(qd);
}

}  // namespace passive_haptics
