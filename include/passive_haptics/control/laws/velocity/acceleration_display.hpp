/// Accelerations of the end effector normal to a wall and of the brakes, under brake torques.
#pragma once

#include <passive_haptics/core/linear/cholesky.hpp>
#include <passive_haptics/core/linear/lane_products.hpp>
#include <passive_haptics/mechanism/dynamics.hpp>
#include <passive_haptics/mechanism/jacobian.hpp>

namespace passive_haptics {

/// A device in one pose with joint rates qd and the mass of a hand. Cost: an n x n Cholesky decomposition.
template <class M>
struct pose_dynamics {
  using T = typename M::scalar;                ///< Scalar.
  static constexpr int n = M::dof;             ///< Joints.
  static constexpr int d = M::task_dimension;  ///< Task dimensions.
  static constexpr int m = M::brake_count;     ///< Brakes.

  jacobian_matrix<M> J;     ///< [m/rad or 1]
  matrix<T, n, m> Tt;       ///< T^T, from brake to joint torques.
  cholesky<T, n> mass;      ///< M, plus J^T m_h J of the hand.
  joint_vector<M> bias;     ///< c [N m]
  task_vector<M> drift;     ///< Jd qd [m/s^2]
  task_vector<M> velocity;  ///< J qd [m/s]
  brake_vector<M> rates;    ///< T qd [rad/s or m/s]

  /// The mechanism in this pose; hand: mass m_h [kg].
  pose_dynamics(const mechanism_pose<M>& pose, const joint_vector<M>& qd, T hand = T(0))
      : J(pose.jacobian()),
        Tt(pose.transposed_transmission()),
        mass(matrix<T, n, n>(pose.mass_matrix() + hand * transposed_times(J, J))),
        bias(pose.bias_torque(qd)),
        drift(pose.bias_acceleration(qd)),
        velocity(J * qd),
        rates(transposed_times(Tt, qd)) {}
};

/// Response of the end effector to brake torques t along a unit normal, n . xdd = free + g . t.
template <class T, int D, int Brakes>
struct normal_response {
  vector<T, D> normal;      ///< n
  vector<T, Brakes> g;      ///< n^T J M^-1 T^T [m/s^2 per N m]; also the brake accelerations for 1 N along n.
  vector<T, D> per_newton;  ///< J M^-1 J^T n [m/s^2 per N]
  T free;                   ///< n^T (J M^-1 (J^T Fh - c) + Jd qd) [m/s^2]
  T inertia;                ///< Lambda_n = 1 / (n^T J M^-1 J^T n) [kg]
};

/// Response along n for a hand force Fh. Cost: one solution with M.
template <class M, class T, int D>
normal_response<T, D, M::brake_count> response_along(const vector<T, D>& n, const pose_dynamics<M>& dynamics,
                                                     const vector<T, D>& Fh) {
  const joint_vector<M> Jn = transposed_times(dynamics.J, n), y = dynamics.mass.solve(Jn);
  const joint_vector<M> drive = transposed_times(dynamics.J, Fh) - dynamics.bias;
  return {n, transposed_times(dynamics.Tt, y), dynamics.J * y, y.dot(drive) + n.dot(dynamics.drift),
          T(1) / Jn.dot(y)};
}

}  // namespace passive_haptics
