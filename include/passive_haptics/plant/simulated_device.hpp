/// @file
/// A device without hardware: a mechanism with inertia, lagging brakes and a hand's mass on its handle.
#pragma once

#include <passive_haptics/brake/brake_jacobian.hpp>
#include <passive_haptics/brake/brake_parameters.hpp>
#include <passive_haptics/mechanism/dynamics.hpp>
#include <passive_haptics/plant/box_friction.hpp>
#include <passive_haptics/plant/first_order_lag.hpp>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <utility>

namespace passive_haptics {

/// Simulated device: M qdd + c = J^T Fh + T^T t, where the brakes are Coulomb friction with exact stick whose
/// strength follows the commanded capacity with a first-order lag.
///
/// Semi-implicit Euler on impulses: rates first (friction implicit), then positions with the new rates. The hand's
/// mass moves with the handle; the hand's force drives both, a sensor between them feels what reaches the device.
template <class M>
class simulated_device {
  static_assert(mechanism_requirements<M>::met);
  static_assert(Dynamics<M>,
                "passive_haptics: a simulated device needs a mechanism that models Dynamics "
                "(mass_matrix, bias_torque, bias_acceleration; mechanism/dynamics.hpp).");

 public:
  using scalar = typename M::scalar;  ///< Scalar of the mechanism.

  /// At rest at q. hand_mass [kg] moves with the handle. Throws std::invalid_argument with the text of
  /// validate(brakes), or if the mass is negative or not finite.
  simulated_device(M mechanism, const brakes_of<M>& brakes, scalar hand_mass, const joint_vector<M>& q)
      : mechanism_(std::move(mechanism)),
        brakes_(require_valid(brakes)),
        strength_(brakes.time_constant),
        hand_mass_(hand_mass),
        q_(q) {
    require_no_complaint(detail::check_not_negative("hand_mass [kg]", hand_mass));
  }

  /// Sets the motion, for example at the start of an experiment.
  void set_motion(const joint_vector<M>& q, const joint_vector<M>& qd) {
    q_ = q;
    qd_ = qd;
  }

  /// One time step dt [s] under commanded capacities [N m] and the force [N] that the hand's muscles exert.
  void advance(scalar dt, const brake_vector<M>& capacity, const task_vector<M>& muscle_force) {
    using square = matrix<scalar, M::dof, M::dof>;
    const task_matrix J = task_matrix(jacobian(mechanism_, q_));
    const task_vector<M> drift = mechanism_.bias_acceleration(q_, qd_);
    const square mass = mechanism_.mass_matrix(q_) + hand_mass_ * J.transpose() * J;
    const joint_vector<M> drive =
        J.transpose() * (muscle_force - hand_mass_ * drift) - mechanism_.bias_torque(q_, qd_);
    const Eigen::LLT<square> inverse_mass(mass);

    const joint_vector<M> free = qd_ + dt * inverse_mass.solve(drive);
    const auto Tt = transposed_transmission();
    const matrix<scalar, M::brake_count, M::brake_count> A = Tt.transpose() * inverse_mass.solve(Tt);
    const brake_vector<M> limit =
        dt * strength_.advance(dt, capacity.cwiseMin(brakes_.torque_limit).cwiseMax(scalar(0)));
    const auto friction = solve_box_friction<scalar, M::brake_count>(A, Tt.transpose() * free, limit);

    const joint_vector<M> next = free + inverse_mass.solve(Tt * friction.impulse);
    sensed_force_ = muscle_force - hand_mass_ * (J * (next - qd_) / dt + drift);
    brake_torque_ = friction.impulse / dt;
    qd_ = next;
    q_ += dt * qd_;
  }

  /// Joint positions [rad or m].
  const joint_vector<M>& q() const { return q_; }
  /// Joint rates [rad/s or m/s].
  const joint_vector<M>& qd() const { return qd_; }
  /// Handle [m].
  task_vector<M> position() const { return mechanism_.position(q_); }
  /// Velocity of the handle [m/s].
  task_vector<M> velocity() const { return jacobian(mechanism_, q_) * qd_; }
  /// Rates of the brakes' axes [rad/s or m/s].
  brake_vector<M> rates() const { return brake_rates(mechanism_, q_, qd_); }
  /// Force of the hand on the handle in the last step [N]: muscle force less what moved the hand's own mass.
  const task_vector<M>& sensed_force() const { return sensed_force_; }
  /// Mean torque of the brakes in the last step [N m].
  const brake_vector<M>& brake_torque() const { return brake_torque_; }
  /// What the brakes could hold now [N m].
  const brake_vector<M>& brake_strength() const { return strength_.output(); }
  /// The mechanism.
  const M& mechanism() const { return mechanism_; }

 private:
  using task_matrix = matrix<scalar, M::task_dimension, M::dof>;

  matrix<scalar, M::dof, M::brake_count> transposed_transmission() const {
    using wide = matrix<scalar, M::brake_count, M::dof>;
    if constexpr (detail::has_exact_transmission<M>) return wide(transmission(mechanism_, q_)).transpose();
    else return wide::Identity();
  }

  M mechanism_;
  brakes_of<M> brakes_;
  first_order_lag<scalar, M::brake_count> strength_;
  scalar hand_mass_;
  joint_vector<M> q_;
  joint_vector<M> qd_ = joint_vector<M>::Zero();
  task_vector<M> sensed_force_ = task_vector<M>::Zero();
  brake_vector<M> brake_torque_ = brake_vector<M>::Zero();
};

}  // namespace passive_haptics
