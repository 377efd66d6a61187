/// Generalised-momentum observer of the hand force, for devices with brakes.
#pragma once

#include <passive_haptics/brake/signs.hpp>
#include <passive_haptics/control/device_state.hpp>
#include <passive_haptics/control/laws/velocity/brake_lag.hpp>
#include <passive_haptics/control/rising_time.hpp>
#include <passive_haptics/control/sensorless/hand_force_estimate.hpp>
#include <passive_haptics/core/finite.hpp>
#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/mechanism/dynamically_consistent_inverse.hpp>
#include <passive_haptics/mechanism/dynamics.hpp>
#include <passive_haptics/mechanism/jacobian.hpp>

#include <cmath>
#include <utility>

namespace passive_haptics {

/// Constants of a momentum_observer.
struct momentum_observer_parameters {
  double gain = 100;         ///< K [1/s]: the estimate is 1 / K late, by two lags of 1 / (2 K).
  double max_period = 0.02;  ///< The observer restarts after a longer pause between two states [s].

  static constexpr auto members() {
    using p = momentum_observer_parameters;
    return member_table(member("gain", &p::gain, "1/s", range::positive),
                        member("max_period", &p::max_period, "s", range::positive));
  }
};

/// Estimates tau = J^T Fh from the momentum p = M qd, pd = tau + T^T t + Md qd - c. Its mean over a period h,
///
///     h tau_mean = (M0 + M1) (qd1 - qd0) / 2 + h (c0 + c1) / 2 - h T^T t_mean
///
/// passes through two first-order lags, rd = 2 K (s - r), sd = 2 K (tau - s), exact for constant tau; no
/// acceleration is measured. (One lag of 1 / K has the same delay but more noise: an error of 0.43 N instead
/// of 0.10 N for a hand force of 0.74 N along a wall, simulated with 8192 counts per revolution and rates
/// low-passed at 50 Hz.) A brake that slips one way throughout the period has t_mean = -sgn(w) times its
/// strength, the lagged capacity. For a brake that rests or reverses, t_mean = 0, and its strength, lagged
/// like r, is the uncertainty. The lagged hand torque is therefore always r + T^T t with |t_i| <=
/// unknown_torque_i.
///
/// The force is that of r by the dynamically consistent inverse; for n > d this ignores hand torques on the
/// self-motion. Starts with r = 0 and unknown strengths. Unmodelled effects (friction, cables, errors of M
/// and of the brakes) appear as hand force.
///
/// Errors: see hand_force_estimate::outcome; the next valid state restarts the observer. Does not allocate.
/// Cost: a Cholesky decomposition of n x n, an orthogonal decomposition of n x d. Sources: De Luca, Mattone,
/// Actuator failure detection and isolation using generalized momenta, IEEE Int. Conf. on Robotics and
/// Automation, 2003, 634-639; De Luca, Albu-Schaeffer, Haddadin, Hirzinger, Collision detection and safe
/// reaction with the DLR-III lightweight manipulator arm, IROS 2006, 1623-1630; for n > d Khatib 1987.
/// Assumptions: the trapezoidal rule for c and Md, and the treatment of brakes.
template <class M>
class momentum_observer {
  static_assert(is_mechanism<M, explain>());
  static_assert(!Mechanism<M> || Dynamics<M>,
                "passive_haptics: a momentum observer needs a mechanism that models Dynamics "
                "(mechanism/dynamics.hpp).");

 public:
  using scalar = typename M::scalar;             ///< Scalar type.
  using estimate_type = hand_force_estimate<M>;  ///< Type of the estimate.

  /// Throws std::invalid_argument if validate(brakes) or validate(p) returns an error.
  momentum_observer(M mechanism, const brakes_of<M>& brakes, const momentum_observer_parameters& p = {})
      : mechanism_(std::move(mechanism)), brakes_(require_valid(brakes)), p_(require_valid(p)) {}

  /// Updates the estimate from time, q and qd. capacity: commanded since the previous state [N m].
  template <class State>
    requires DeviceState<State, M>
  const estimate_type& update(const State& state, const brake_vector<M>& capacity) noexcept {
    const brake_vector<M> strength = mean_strength(state.time, capacity);
    const motion now = motion_of(state);
    estimate_.outcome = verdict(state, now, capacity);
    if (estimate_.outcome == status::ok) estimate_.outcome = time_.next(state.time);
    if (estimate_.outcome != status::ok) {
      start_anew();
      return estimate_;
    }
    const double h = state.time - before_.time;
    const bool follows = started_ && h <= p_.max_period;
    const auto Tt = passive_haptics::transposed_transmission(mechanism_, state.q);
    if (follows) {
      brake_vector<M> known = brake_vector<M>::Zero(), unknown = strength;
      unrolled<M::brake_count>([&](auto i) {
        if (!slipped(i, now)) return;
        known[i] = -sgn(now.w[i]) * strength[i];
        unknown[i] = scalar(0);
      });
      const joint_torque inertial =
          (before_.mass + now.mass) * (now.qd - before_.qd) / static_cast<scalar>(2 * h);
      const joint_torque tau = inertial + (before_.bias + now.bias) / scalar(2) - Tt * known;
      residual_.follow(tau, h, p_.gain);
      unknown_.follow(unknown, h, p_.gain);
    } else {
      residual_ = {};
      unknown_ = {strength, strength};
    }
    estimate_.unknown_torque = unknown_.twice;
    before_ = now;
    started_ = true;
    estimate_.outcome = to_force(state.q, now, Tt);
    return estimate_;
  }

  const estimate_type& estimate() const { return estimate_; }  ///< The estimate of the last update.
  /// r [N m or N]: the hand's joint torques if brakes at rest have no torque.
  const joint_vector<M>& joint_torques() const { return residual_.twice; }
  /// Forgets everything except the brake strengths.
  void reset() {
    start_anew();
    time_ = {};
  }

 private:
  static constexpr int n = M::dof, d = M::task_dimension, m = M::brake_count;
  using joint_torque = joint_vector<M>;
  struct motion {
    double time = 0;
    joint_vector<M> qd = joint_vector<M>::Zero(), bias = joint_vector<M>::Zero();
    brake_vector<M> w = brake_vector<M>::Zero();
    matrix<scalar, n, n> mass = matrix<scalar, n, n>::Zero();
  };

  // After one lag of 1 / (2 K), and after two.
  template <class Vector>
  struct twice_lagged {
    Vector once = Vector::Zero(), twice = Vector::Zero();
    void follow(const Vector& x, double h, double gain) {
      const scalar lags = static_cast<scalar>(2 * gain * h), left = std::exp(-lags);
      twice = x + left * (twice - x + lags * (once - x));
      once = x + left * (once - x);
    }
  };

  void start_anew() {
    started_ = false;
    residual_ = {};
    const status outcome = estimate_.outcome;
    estimate_ = estimate_type();
    estimate_.outcome = outcome;
  }

  template <class State>
  motion motion_of(const State& state) const {
    return {state.time, state.qd, mechanism_.bias_torque(state.q, state.qd),
            passive_haptics::brake_rates(mechanism_, state.q, state.qd), mechanism_.mass_matrix(state.q)};
  }

  template <class State>
  static status verdict(const State& state, const motion& now, const brake_vector<M>& capacity) {
    if (!all_finite(state.time, state.q, state.qd, capacity)) return status::state_not_finite;
    return all_finite(now.bias, now.w, now.mass) ? status::ok : status::pose_undefined;
  }

  // Mean over the period of a strength with T_b dtau/dt + tau = u: u - T_b (tau1 - tau0) / h
  brake_vector<M> mean_strength(double time, const brake_vector<M>& capacity) {
    brake_vector<M> u, mean, before;
    unrolled<m>([&](auto i) {
      const scalar commanded = std::isfinite(capacity[i]) ? capacity[i] : brakes_.torque_limit[i];
      u[i] = lag_.command(i, commanded, brakes_.torque_limit[i]);
      before[i] = static_cast<scalar>(lag_.torque(i));
    });
    const double h = time - before_.time;
    lag_.advance(time, brakes_.time_constant);
    unrolled<m>([&](auto i) {
      const scalar after = static_cast<scalar>(lag_.torque(i));
      const bool lags = started_ && h > 0 && brakes_.time_constant[i] > scalar(0);
      mean[i] = lags ? u[i] - brakes_.time_constant[i] * (after - before[i]) / static_cast<scalar>(h) : after;
    });
    // A very short period would amplify rounding
    return mean.cwiseMax(scalar(0)).cwiseMin(brakes_.torque_limit);
  }

  bool slipped(int i, const motion& now) const {
    const scalar band = brakes_.rate_dead_band[i];
    return slips(before_.w[i], band) && slips(now.w[i], band) && sgn(before_.w[i]) == sgn(now.w[i]);
  }

  status to_force(const joint_vector<M>& q, const motion& now, const matrix<scalar, n, m>& Tt) {
    estimate_.force.setZero();
    estimate_.generators.setZero();
    const dynamically_consistent_inverse<scalar, n, d> inverse(
        matrix<scalar, d, n>(passive_haptics::jacobian(mechanism_, q)), now.mass,
        rounding_tolerance<scalar>(n));
    if (!inverse.defined()) return status::pose_undefined;
    if (!inverse.exists()) return status::singular_jacobian;
    estimate_.force = inverse.forces(residual_.twice);
    estimate_.generators = inverse.forces(Tt);
    return status::ok;
  }

  M mechanism_;
  brakes_of<M> brakes_;
  momentum_observer_parameters p_;
  brake_lag_model lag_;
  rising_time time_;
  bool started_ = false;
  motion before_;
  twice_lagged<joint_torque> residual_;
  twice_lagged<brake_vector<M>> unknown_;
  estimate_type estimate_;
};

}  // namespace passive_haptics
