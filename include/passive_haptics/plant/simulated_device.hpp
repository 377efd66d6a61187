/// A simulated device: a mechanism with inertia, brakes, and a hand's mass on its handle.
#pragma once

#include <passive_haptics/brake/force_generators.hpp>
#include <passive_haptics/core/linear/cholesky.hpp>
#include <passive_haptics/core/linear/lane_products.hpp>
#include <passive_haptics/mechanism/dynamically_consistent_inverse.hpp>
#include <passive_haptics/mechanism/dynamics.hpp>
#include <passive_haptics/mechanism/jacobian.hpp>
#include <passive_haptics/plant/box_friction.hpp>
#include <passive_haptics/plant/brakes/coulomb_brake.hpp>
#include <passive_haptics/plant/energy_balance.hpp>
#include <passive_haptics/plant/simulated_device_declaration.hpp>

#include <algorithm>
#include <concepts>
#include <utility>

namespace passive_haptics {

struct detail::simulated_device_header {};

/// Simulated device M qdd + c = J^T Fh + T^T t. The brakes are Coulomb friction with exact stick and viscous
/// drag, by the Model of each brake; its compliance is a spring in series with the friction. Semi-implicit
/// Euler on impulses, first order in dt: the resistances at the old rates, then the new rates (friction and
/// drag implicit), then positions. The hand's mass moves with the handle; a sensor between them measures the
/// force that reaches the device.
template <class M, class Model>
  requires(detail::has_simulated_device<M>())
class simulated_device {
  static_assert(is_mechanism<M, explain>() && is_brake_model<Model, explain>());
  static_assert(!Mechanism<M> || Dynamics<M>,
                "passive_haptics: a simulated device needs a mechanism that models Dynamics "
                "(mass_matrix, bias_torque, bias_acceleration; mechanism/dynamics.hpp).");

 public:
  using scalar = typename M::scalar;  ///< Scalar of the mechanism.

  /// At rest at q, with ideal_brakes; hand_mass [kg] moves with the handle. Throws std::invalid_argument with
  /// the text of validate(brakes), or if the mass is negative or not finite.
  simulated_device(M mechanism, const brakes_of<M>& brakes, scalar hand_mass, const joint_vector<M>& q)
    requires std::same_as<Model, coulomb_brake<scalar>>
      : simulated_device(std::move(mechanism), ideal_brakes(require_valid(brakes)), hand_mass, q) {}

  /// A device with brakes that may differ from the controller's parameters.
  template <std::same_as<brake_models_of<M, Model>> RealBrakes>  // a template, so that {} means brakes_of<M>
  simulated_device(M mechanism, const RealBrakes& brakes, scalar hand_mass, const joint_vector<M>& q)
      : mechanism_(std::move(mechanism)), brakes_(brakes), hand_mass_(hand_mass) {
    if constexpr (Parameters<Model>) require_no_error(check_value("brakes", brakes, "", range::anything));
    require_no_error(check_value("hand_mass", hand_mass, "kg", range::not_negative));
    set_motion(q, joint_vector<M>::Zero());
  }

  /// Sets the motion, for example at the start of an experiment, and restarts the energy balance.
  void set_motion(const joint_vector<M>& q, const joint_vector<M>& qd) {
    q_ = q;
    qd_ = qd;
    measure_pose();
    friction_.setZero();
    energy_ = energy_balance();
    energy_.start = energy_.kinetic = kinetic_energy();
  }

  /// Advances by dt [s] under commanded capacities [N m] and the muscle force of the hand [N]; not if dt is
  /// not a finite number > 0. Diverges to NaN if dt exceeds about twice the minimum time constant of the
  /// hand.
  void advance(scalar dt, const brake_vector<M>& capacity, const task_vector<M>& muscle_force) {
    if (valid_time_step(dt) == scalar(0)) return;
    const matrix<scalar, M::dof, M::brake_count> Tt =
        passive_haptics::transposed_transmission(mechanism_, q_);
    const transmission_matrix<M> T = transposed(Tt);
    const resistances now = resist(dt, capacity, T * qd_);
    const task_vector<M> F = muscle_force - hand_mass_ * mechanism_.bias_acceleration(q_, qd_);
    const joint_vector<M> drive = transposed_times(J_, F) - mechanism_.bias_torque(q_, qd_);

    // (M + dt T^T B T) qd' = M qd + dt (J^T F - c) + T^T p, with the drag B and the friction impulses p
    const transmission_matrix<M> drag = scaled_rows(dt * (now.commanded_drag + now.residual_drag), T);
    const cholesky<scalar, M::dof> inverse_mass(mass_ + Tt * drag);
    const joint_vector<M> free = inverse_mass.solve(joint_vector<M>(mass_ * qd_ + dt * drive));
    const brake_vector<M> p = friction_impulses(dt, now, T * inverse_mass.solve(Tt), T * free);
    const joint_vector<M> next = free + inverse_mass.solve(joint_vector<M>(Tt * p));

    const brake_vector<M> rates = T * next;
    friction_ = p / dt;
    brake_torque_ = scalar(1) / dt * p - entrywise_product(now.commanded_drag, rates);
    brake_power_ = entrywise_product(brake_torque_, rates);
    sensed_force_ = F - hand_mass_ / dt * (J_ * (next - qd_));
    const joint_vector<M> middle = (qd_ + next) / scalar(2);
    count_work(dt, muscle_force, middle);
    count_losses(dt, now, p, rates, T * middle);
    qd_ = next;
    q_ += dt * qd_;
    measure_pose();
    energy_.kinetic = kinetic_energy();
  }

  const joint_vector<M>& q() const { return q_; }        ///< Joint positions [rad or m].
  const joint_vector<M>& qd() const { return qd_; }      ///< Joint rates [rad/s or m/s].
  const task_vector<M>& position() const { return x_; }  ///< Position of the handle [m].
  task_vector<M> velocity() const { return J_ * qd_; }   ///< Velocity of the handle [m/s].
  /// Rates of the brakes' axes [rad/s or m/s].
  brake_vector<M> rates() const { return passive_haptics::brake_rates(mechanism_, q_, qd_); }
  /// Force of the hand on the handle in the last step [N]: muscle force minus inertia of the hand.
  const task_vector<M>& sensed_force() const { return sensed_force_; }
  /// Mean torque of the brakes in the last step [N m]: friction, commanded and residual, and commanded drag.
  const brake_vector<M>& brake_torque() const { return brake_torque_; }
  /// t_i w_i at the end of the last step [W]: <= 0 to rounding, except energy returned by a compliance.
  const brake_vector<M>& brake_power() const { return brake_power_; }
  /// Commanded holding torque of the brakes [N m], without residual friction.
  const brake_vector<M>& brake_strength() const { return strength_; }
  /// Lower bound of the mass of device and hand at the handle in this pose [kg]: 1 / |J M^-1 J^T|. The mass
  /// in the lightest direction is at most sqrt(d) times larger.
  scalar min_mass() const {
    const cholesky<scalar, M::dof> inverse_mass(mass_);
    return scalar(1) / (J_ * inverse_mass.solve(transposed(J_))).norm();
  }
  /// Energy balance since the start or the last set_motion.
  const energy_balance& energy() const { return energy_; }
  const M& mechanism() const { return mechanism_; }  ///< The mechanism.

  /// Force at the handle equivalent to brake_torque() in this pose [N]: J^-T T^T t, for n > d by the
  /// dynamically consistent inverse. Not finite if J does not have full row rank.
  task_vector<M> brake_force() const {
    if constexpr (M::dof == M::task_dimension) {
      return passive_haptics::force_generators(mechanism_, q_) * brake_torque_;
    } else {
      // The hand's mass does not matter, so it may stay in M
      const dynamically_consistent_inverse<scalar, M::dof, M::task_dimension> inverse(J_, mass_);
      return inverse.forces(
          joint_vector<M>(passive_haptics::transposed_transmission(mechanism_, q_) * brake_torque_));
    }
  }

 private:
  using joint_matrix = matrix<scalar, M::dof, M::dof>;
  using task_matrix = jacobian_matrix<M>;
  using brake_matrix = matrix<scalar, M::brake_count, M::brake_count>;

  // In addition to strength_.
  struct resistances {
    brake_vector<M> commanded_drag, residual_strength, residual_drag, compliance;
  };

  static double as_double(scalar x) { return static_cast<double>(x); }

  // Advances the brakes by dt; rates are the old ones.
  resistances resist(scalar dt, const brake_vector<M>& capacity, const brake_vector<M>& rates) {
    resistances all;
    for (int i = 0; i < M::brake_count; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const brake_resistance<scalar> commanded = brakes_[k].advance(dt, capacity[i], rates[i], states_[k]);
      const brake_resistance<scalar> residual = residual_of(brakes_[k]);
      strength_[i] = commanded.strength;
      all.commanded_drag[i] = commanded.drag;
      all.residual_strength[i] = residual.strength;
      all.residual_drag[i] = residual.drag;
      all.compliance[i] = compliance_of(brakes_[k]);
    }
    return all;
  }

  // Friction impulses; w0: rates of the brakes' axes without friction, A: change of rates per N m s.
  brake_vector<M> friction_impulses(scalar dt, const resistances& now, brake_matrix A,
                                    brake_vector<M> w0) const {
    // A shaft of compliance c does not slip if w = -c (p / dt - t) / dt, with t the previous friction: the
    // condition of stick with A + c / dt^2 and w0 - c t / dt
    const brake_vector<M> give = now.compliance / (dt * dt);
    for (int i = 0; i < M::brake_count; ++i) A(i, i) += give[i];
    w0 -= dt * entrywise_product(give, friction_);
    const brake_vector<M> limit = dt * (strength_ + now.residual_strength);
    if constexpr (M::brake_count > M::dof)
      return solve_redundant_box_friction<scalar, M::brake_count>(A, w0, limit).impulse;
    else return solve_box_friction<scalar, M::brake_count>(A, w0, limit).impulse;
  }

  void count_work(scalar dt, const task_vector<M>& muscle_force, const joint_vector<M>& middle) {
    const joint_vector<M> gravity = mechanism_.bias_torque(q_, joint_vector<M>::Zero());
    energy_.hand += as_double(dt * muscle_force.dot(J_ * middle));
    energy_.gravity -= as_double(dt * gravity.dot(middle));
  }

  // Losses by friction impulses p and by drag at the new rates; commanded friction by its share of the limit.
  void count_losses(scalar dt, const resistances& now, const brake_vector<M>& p, const brake_vector<M>& rates,
                    const brake_vector<M>& middle) {
    for (int i = 0; i < M::brake_count; ++i) {
      const scalar limit = dt * (strength_[i] + now.residual_strength[i]);
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
    J_ = task_matrix(pose.jacobian());
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
  task_matrix J_;
  joint_matrix mass_;  // device and hand
  energy_balance energy_;
  task_vector<M> sensed_force_ = task_vector<M>::Zero();
  brake_vector<M> brake_torque_ = brake_vector<M>::Zero();
  brake_vector<M> brake_power_ = brake_vector<M>::Zero();
};

/// Deduces Model from an array with one model for each brake.
template <class M, class Model, std::size_t Brakes>
simulated_device(M, const std::array<Model, Brakes>&, typename M::scalar, const joint_vector<M>&)
    -> simulated_device<M, Model>;

}  // namespace passive_haptics
