/// @file
/// Motion, brakes and energy of a device in a simulation: the readings that all plants have.
#pragma once

#include <passive_haptics/brake/force_generators.hpp>
#include <passive_haptics/core/linear/cholesky.hpp>
#include <passive_haptics/core/linear/lane_products.hpp>
#include <passive_haptics/mechanism/dynamically_consistent_inverse.hpp>
#include <passive_haptics/mechanism/dynamics.hpp>
#include <passive_haptics/mechanism/jacobian.hpp>
#include <passive_haptics/plant/brakes/coulomb_brake.hpp>
#include <passive_haptics/plant/energy_balance.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace passive_haptics {

/// The common part of all plants, which does not depend on how the next rates are computed: readings, brake
/// models and the energy balance. A plant derives from it, and its advance() calls begin_step(), computes the
/// impulses of friction and the new rates, and calls end_step().
template <class M, class Model = coulomb_brake<typename M::scalar>>
class moving_device {
  static_assert(is_mechanism<M, explain>() && is_brake_model<Model, explain>());
  static_assert(!Mechanism<M> || Dynamics<M>,
                "passive_haptics: a simulated device needs a mechanism that models Dynamics "
                "(mass_matrix, bias_torque, bias_acceleration; mechanism/dynamics.hpp).");

 public:
  using scalar = typename M::scalar;  ///< Scalar of the mechanism.

  /// Joint positions [rad or m].
  const joint_vector<M>& q() const { return q_; }
  /// Joint rates [rad/s or m/s].
  const joint_vector<M>& qd() const { return qd_; }
  /// Handle [m].
  const task_vector<M>& position() const { return x_; }
  /// Velocity of the handle [m/s].
  task_vector<M> velocity() const { return J_ * qd_; }
  /// Rates of the brakes' axes [rad/s or m/s].
  brake_vector<M> rates() const { return passive_haptics::brake_rates(mechanism_, q_, qd_); }
  /// Force of the hand on the handle in the last step [N]: muscle force less what moved the hand's own mass.
  const task_vector<M>& sensed_force() const { return sensed_force_; }
  /// Mean torque of the brakes in the last step [N m]: friction, commanded and residual, and commanded drag.
  const brake_vector<M>& brake_torque() const { return brake_torque_; }
  /// t_i w_i of it with the rates at the end of the last step [W]. A simulated_device keeps it <= 0 to
  /// rounding, unless a compliance returns energy.
  const brake_vector<M>& brake_power() const { return brake_power_; }
  /// What the brakes could hold at rest now by command [N m], without residual friction.
  const brake_vector<M>& brake_strength() const { return strength_; }
  /// Lower bound of the mass that a force at the handle moves, device and hand [kg], here and now:
  /// 1 / |J M^-1 J^T|. The mass in the lightest direction is at most sqrt(d) times larger.
  scalar min_mass() const {
    const cholesky<scalar, M::dof> inverse_mass(mass_);
    return scalar(1) / (J_ * inverse_mass.solve(transposed(J_))).norm();
  }
  /// Where the energy came from and went since the last set_motion, or the start.
  const energy_balance& energy() const { return energy_; }
  /// The mechanism.
  const M& mechanism() const { return mechanism_; }

  /// The force at the handle that does to it what brake_torque() does [N], here and now: J^-T T^T t, and for
  /// n > d by the dynamically consistent inverse. Not finite where J has not full row rank.
  task_vector<M> brake_force() const {
    if constexpr (M::dof == M::task_dimension) {
      return passive_haptics::force_generators(mechanism_, q_) * brake_torque_;
    } else {
      // The hand's mass changes nothing, so it may stay in M
      const dynamically_consistent_inverse<scalar, M::dof, M::task_dimension> inverse(J_, mass_);
      return inverse.forces(
          joint_vector<M>(passive_haptics::transposed_transmission(mechanism_, q_) * brake_torque_));
    }
  }

 protected:
  /// A step with known brakes and unknown motion.
  struct step {
    scalar dt;                    ///< [s]
    task_vector<M> muscle_force;  ///< Of the hand [N].
    task_vector<M> device_force;  ///< muscle_force less what moves the hand's mass at constant rates [N].
    transmission_matrix<M> T;     ///< Before the step.
    brake_vector<M> limit;        ///< Of friction, commanded and residual [N m].
    brake_vector<M> residual_strength;  ///< The residual part of it [N m].
    brake_vector<M> commanded_drag;     ///< [N m s]
    brake_vector<M> residual_drag;      ///< [N m s]
  };

  /// At rest at q. Throws std::invalid_argument if a brake or the hand's mass [kg] is out of range.
  moving_device(M mechanism, const brake_models_of<M, Model>& brakes, scalar hand_mass,
                const joint_vector<M>& q)
      : mechanism_(std::move(mechanism)), brakes_(brakes), hand_mass_(hand_mass) {
    if constexpr (Parameters<Model>) require_no_error(check_value("brakes", brakes, "", range::anything));
    require_no_error(check_value("hand_mass", hand_mass, "kg", range::not_negative));
    set_motion(q, joint_vector<M>::Zero());
  }

  /// Sets the motion, for example at the start of an experiment, and begins the energy balance again.
  void set_motion(const joint_vector<M>& q, const joint_vector<M>& qd) {
    q_ = q;
    qd_ = qd;
    measure_pose();
    friction_.setZero();
    energy_ = energy_balance();
    energy_.start = energy_.kinetic = kinetic_energy();
  }

  /// Brings the brakes forward by dt [s] under these capacities [N m]. Their models see the rates before the
  /// step.
  step begin_step(scalar dt, const brake_vector<M>& capacity, const task_vector<M>& muscle_force) {
    step now;
    now.dt = dt;
    now.muscle_force = muscle_force;
    now.device_force = muscle_force - hand_mass_ * mechanism_.bias_acceleration(q_, qd_);
    now.T = transposed(passive_haptics::transposed_transmission(mechanism_, q_));
    const brake_vector<M> rates = now.T * qd_;
    for (int i = 0; i < M::brake_count; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const brake_resistance<scalar> commanded = brakes_[k].advance(dt, capacity[i], rates[i], states_[k]);
      const brake_resistance<scalar> residual = residual_of(brakes_[k]);
      strength_[i] = commanded.strength;
      now.residual_strength[i] = residual.strength;
      now.commanded_drag[i] = commanded.drag;
      now.residual_drag[i] = residual.drag;
    }
    now.limit = strength_ + now.residual_strength;
    return now;
  }

  /// Moves the device to the end of the step, with the brakes' impulses of friction p [N m s] and the new
  /// joint rates, and accounts for it.
  void end_step(const step& now, const brake_vector<M>& p, const joint_vector<M>& next) {
    const scalar dt = now.dt;
    const brake_vector<M> rates = now.T * next;
    friction_ = p / dt;
    brake_torque_ = scalar(1) / dt * p - entrywise_product(now.commanded_drag, rates);
    brake_power_ = entrywise_product(brake_torque_, rates);
    sensed_force_ = now.device_force - hand_mass_ / dt * (J_ * (next - qd_));
    const joint_vector<M> middle = (qd_ + next) / scalar(2);
    count_work(now, middle);
    count_losses(now, p, rates, now.T * middle);
    qd_ = next;
    q_ += dt * qd_;
    measure_pose();
    energy_.kinetic = kinetic_energy();
  }

  /// J
  const jacobian_matrix<M>& jacobian() const { return J_; }
  /// M of device and hand.
  const matrix<scalar, M::dof, M::dof>& mass() const { return mass_; }
  /// Mean friction of the brakes in the last step, commanded and residual [N m].
  const brake_vector<M>& friction() const { return friction_; }
  /// Elastic turn of the brakes [rad/(N m)].
  brake_vector<M> compliance() const {
    brake_vector<M> all;
    for (int i = 0; i < M::brake_count; ++i) all[i] = compliance_of(brakes_[static_cast<std::size_t>(i)]);
    return all;
  }

 private:
  static double as_double(scalar x) { return static_cast<double>(x); }

  // Works of a step, at the mid-point rates: see energy_balance.
  void count_work(const step& now, const joint_vector<M>& middle) {
    const joint_vector<M> gravity = mechanism_.bias_torque(q_, joint_vector<M>::Zero());
    energy_.hand += as_double(now.dt * now.muscle_force.dot(J_ * middle));
    energy_.gravity -= as_double(now.dt * gravity.dot(middle));
  }

  // Losses of a step by friction of impulses p and by drag at the new rates. What the command causes of the
  // friction is its share of the limit.
  void count_losses(const step& now, const brake_vector<M>& p, const brake_vector<M>& rates,
                    const brake_vector<M>& middle) {
    const scalar dt = now.dt;
    for (int i = 0; i < M::brake_count; ++i) {
      const scalar limit = dt * now.limit[i];
      const double share = limit > scalar(0) ? as_double(dt * strength_[i] / limit) : 0.0;
      const double dissipated = -as_double(p[i] * middle[i]);
      energy_.brakes += share * dissipated + as_double(dt * (now.commanded_drag[i] * rates[i]) * middle[i]);
      energy_.residual_friction += (1 - share) * dissipated;
      energy_.drag += as_double(dt * rates[i] * now.residual_drag[i] * middle[i]);
      energy_.max_brake_power = std::max(energy_.max_brake_power, as_double(brake_power_[i]));
    }
  }

  void measure_pose() {
    const mechanism_pose<M> pose(mechanism_, q_);
    x_ = pose.position();
    J_ = jacobian_matrix<M>(pose.jacobian());
    mass_ = pose.mass_matrix() + hand_mass_ * transposed_times(J_, J_);
  }

  double kinetic_energy() const { return as_double(qd_.dot(mass_ * qd_)) / 2; }

  M mechanism_;
  brake_models_of<M, Model> brakes_;
  std::array<typename Model::state, static_cast<std::size_t>(M::brake_count)> states_{};
  brake_vector<M> strength_ = brake_vector<M>::Zero();
  brake_vector<M> friction_ = brake_vector<M>::Zero();  // commanded and residual, without drag [N m]
  scalar hand_mass_;
  joint_vector<M> q_, qd_;
  task_vector<M> x_;
  jacobian_matrix<M> J_;
  matrix<scalar, M::dof, M::dof> mass_;  // device and hand
  energy_balance energy_;
  task_vector<M> sensed_force_ = task_vector<M>::Zero();
  brake_vector<M> brake_torque_ = brake_vector<M>::Zero();
  brake_vector<M> brake_power_ = brake_vector<M>::Zero();
};

}  // namespace passive_haptics
