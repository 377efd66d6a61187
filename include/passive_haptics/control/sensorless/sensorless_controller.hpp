/// A controller for devices without a force sensor, with laws that need a hand force.
#pragma once

#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/laws/velocity/brake_lag.hpp>
#include <passive_haptics/control/sensorless/momentum_observer.hpp>
#include <passive_haptics/control/sensorless/release_probe.hpp>
#include <passive_haptics/core/nth.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace passive_haptics {

/// Constants of a sensorless_controller.
struct sensorless_parameters {
  momentum_observer_parameters observer = {};  ///< For the hand force estimate.
  release_probe_parameters probe = {};         ///< For probes of brakes that hold.

  static constexpr auto members() {
    using p = sensorless_parameters;
    return member_table(member("observer", &p::observer), member("probe", &p::probe));
  }
};

/// A controller with a law that uses the force of a momentum_observer, and with probes of holding brakes
/// (release_probe), so that no hand is locked inside a wall or an effect.
///
/// A brake at rest has sign 0 and may hold either way, as for any state without a hand force. While a brake
/// holds, the hand torque on it cannot be observed. The law therefore gets the possible hand force for which
/// the torques on brakes at rest are nearest to the last observed ones, and probes test these values. After a
/// probe, commands are raised until the brakes have the torques that the law assumes.
///
/// A hand that presses without sliding sinks because of the probes: at 2 N by 0.1 to 0.3 mm/s with exact
/// rates, more with coarse encoders (docs/guide/control.md), and in a corner at each wall. There
/// on_off_control holds, which needs no hand force (docs/results.md).
///
/// With effects, a round of probes tests the walls and, for each brake, the effects; each probe releases only
/// the torques of its cause. A hand that pushes with 1 to 3 N creeps by 0.1 to 0.6 mm/s; one that pulls back
/// is free within max_release_time. Limits (docs/guide/effects.md): end stops and friction creep more, and a
/// hand that leaves a wall obliquely may need several rounds.
///
/// For mechanisms that model Dynamics. Errors: as for controller; a cycle that is not later than the previous
/// one returns status::time_not_rising under any law. Cost: the law and the observer.
template <class M, class S, class L>
class sensorless_controller {
 public:
  using mechanism_type = M;                                              ///< The mechanism.
  using options_type = step_options<typename M::scalar>;                 ///< Options of a step.
  using result_type = step_result_for<M, typename S::contacts_type>;     ///< Result of a cycle.
  using probe_phase = typename release_probe<M::task_dimension>::phase;  ///< Phase of the probes.

  /// Throws std::invalid_argument if the brakes, the parameters or the law are invalid.
  sensorless_controller(M mechanism, const brakes_of<M>& brakes, S scene, L law = {},
                        const sensorless_parameters& p = {}, const options_type& options = options_type())
      : observer_(mechanism, brakes, p.observer),
        controller_(std::move(mechanism), with_unknown_pushes(brakes), std::move(scene), std::move(law),
                    options),
        probe_(p.probe) {
    effect_probes_.fill(probe_);
  }

  /// One control cycle. Only time, q and qd of the state are used.
  template <class State>
  result_type operator()(const State& state) noexcept {
    const auto& hand = observer_.update(state, last_capacity_);
    result_type result =
        controller_(device_state<M>{state.time, state.q, state.qd, believed_force(hand, state.q)});
    if (hand.outcome == status::time_not_rising && result.outcome == status::ok) {
      controller_.reset();
      result = released<result_type>(hand.outcome);
    }
    expect(state.time, result.capacity);
    if (result.outcome == status::ok && (in_wall(result) || holds_for_effects(result)))
      probe(state.time, state.q, state.qd, result);
    else forget_rest();
    make_up(result);
    remember(result.capacity);
    return result;
  }

  /// The estimate of the last cycle, with its uncertainty.
  const hand_force_estimate<M>& hand() const { return observer_.estimate(); }
  /// Phase of the probes in the last cycle: probing if any probe is, else released if any is.
  probe_phase probing() const {
    if (any_probe_is(probe_phase::probing)) return probe_phase::probing;
    return any_probe_is(probe_phase::released) ? probe_phase::released : probe_phase::watching;
  }
  /// Forgets the motion so far.
  void reset() {
    observer_.reset();
    controller_.reset();
    assumed_hand_torque_.setZero();
    expected_ = actual_ = brake_lag_model();
    forget_rest();
  }
  S& scene() { return controller_.scene(); }  ///< The scene, e.g. to move one of its walls between cycles.
  const M& mechanism() const { return controller_.mechanism(); }  ///< The mechanism.

 private:
  using scalar = typename M::scalar;
  static constexpr int d = M::task_dimension, m = M::brake_count;
  static constexpr bool has_effects = requires(const result_type& r) { r.torque_for_effects; };
  static constexpr double make_up_time = 0.002;  // [s]: two cycles at 1 kHz
  static constexpr double negligible = 1e-3;     // of a brake's limit
  static constexpr double max_slip_time = 0.02;  // of a brake that only creeps, so counts as at rest [s]

  const brakes_of<M>& brakes() const { return controller_.brakes(); }

  // The torque dead band is infinite because the estimate does not contain the sign of a push at rest.
  static brakes_of<M> with_unknown_pushes(brakes_of<M> brakes) {
    brakes.torque_dead_band.setConstant(std::numeric_limits<typename M::scalar>::max());
    return brakes;
  }

  // Fh [N] with E^T Fh as near as possible to the last value while brakes slipped
  task_vector<M> believed_force(const hand_force_estimate<M>& hand, const joint_vector<M>& q) {
    if (hand.outcome != status::ok) {
      assumed_hand_torque_.setZero();
      return hand.force;
    }
    const brake_vector<M> seen = brake_torque(passive_haptics::brake_jacobian(mechanism(), q), hand.force);
    const brake_vector<M> hidden =
        (assumed_hand_torque_ - seen).cwiseMin(hand.unknown_torque).cwiseMax(-hand.unknown_torque);
    assumed_hand_torque_ = seen + hidden;
    return hand.force + hand.generators * hidden;
  }

  void expect(double time, const brake_vector<M>& capacity) {
    for (brake_lag_model* model : {&expected_, &actual_}) model->advance(time, brakes().time_constant);
    unrolled<m>([&](auto i) {
      counted_on_[i] = expected_.torque(i);
      expected_.command(i, capacity[i], brakes().torque_limit[i]);
    });
  }

  // Raises commands after a probe, until the brakes have the torques that the law assumes.
  void make_up(result_type& result) {
    unrolled<m>([&](auto i) {
      const scalar lag = brakes().time_constant[i], limit = brakes().torque_limit[i], u = result.capacity[i];
      const double missing = counted_on_[i] - actual_.torque(i);
      if (!(u > scalar(0) && lag > scalar(0) && missing > negligible * static_cast<double>(limit))) return;
      const double more = missing * (1 / lag_share(make_up_time, static_cast<double>(lag)) - 1);
      result.capacity[i] = std::min(limit, u + static_cast<scalar>(more));
      result.torque[i] = -result.signs[i] * result.capacity[i];
    });
  }

  void remember(const brake_vector<M>& capacity) {
    last_capacity_ = capacity;
    unrolled<m>([&](auto i) { actual_.command(i, last_capacity_[i], brakes().torque_limit[i]); });
  }

  static bool in_wall(const result_type& result) { return (result.desired_force.array() != scalar(0)).any(); }
  static bool holds_for_effects(const result_type& result) {
    if constexpr (has_effects) return (result.torque_for_effects.array() != scalar(0)).any();
    else return false;
  }

  // One round probes the walls together, and the effects for each brake, along the released force.
  void probe(double time, const joint_vector<M>& q, const joint_vector<M>& qd, result_type& result) {
    const double rest = update_rest(time, passive_haptics::brake_rates(mechanism(), q, qd));
    const auto x = as<double>(mechanism().position(q));
    bool round_ended = false;
    const auto update = [&](release_probe<d>& one, const task_vector<M>& force, double rested) {
      const probe_phase before = one.now(),
                        now = one.update(time, x, direction_of(as<double>(force)), rested);
      round_ended = round_ended || (before != now && now == probe_phase::watching);
      return before != now && now == probe_phase::probing;
    };
    if (!in_wall(result)) probe_.clear();
    else if (update(probe_, result.desired_force, rest))
      unrolled<m>([&](auto i) { nth(probed_, i) = rest_since_[i] < time; });
    const probe_phase walls = probe_.now();
    unrolled<m>([&](auto i) {
      const bool no_walls =
          walls == probe_phase::released || (walls == probe_phase::probing && nth(probed_, i));
      if constexpr (has_effects) {
        const scalar of_walls = result.torque_for_walls[i], of_effects = result.torque_for_effects[i];
        if (of_effects != scalar(0)) side_[i] = sgn(of_effects);
        release_probe<d>& one = nth(effect_probes_, i);
        update(one, observer_.estimate().generators.col(i) * side_[i],
               of_effects != scalar(0) && rest_since_[i] < time ? rest : -1);
        const bool no_effects = one.now() != probe_phase::watching;
        if (no_walls || no_effects)
          hold(i, (no_walls ? scalar(0) : of_walls) + (no_effects ? scalar(0) : of_effects), result);
      } else if (no_walls) {
        result.capacity[i] = result.torque[i] = 0;
      }
    });
    if (round_ended) rest_since_.setConstant(time);
  }

  // Keeps the unprobed part of a brake torque, as far as its sign permits
  void hold(int i, scalar torque, result_type& result) {
    result.capacity[i] = result.signs[i] * torque > scalar(0) ? scalar(0) : std::abs(torque);
    result.torque[i] = -result.signs[i] * result.capacity[i];
    counted_on_[i] = std::min(counted_on_[i], static_cast<double>(result.capacity[i]));
  }

  // Time that some brake has been at rest [s]; 0 during a round of probes
  double update_rest(double time, const brake_vector<M>& w) {
    double rest = 0;
    unrolled<m>([&](auto i) {
      // Regardless of the current command: a law that switches at rest holds by the mean of its commands
      if (!slips(w[i], brakes().rate_dead_band[i])) rested_[i] = time;
      if (time - rested_[i] > max_slip_time || rest_since_[i] > time) rest_since_[i] = time;
      rest = std::max(rest, time - rest_since_[i]);
    });
    return any_probe_is(probe_phase::probing) ? 0 : rest;
  }

  bool any_probe_is(probe_phase phase) const {
    const auto has_phase = [&](const auto& one) { return one.now() == phase; };
    return has_phase(probe_) || std::any_of(effect_probes_.begin(), effect_probes_.end(), has_phase);
  }

  void forget_rest() {
    probe_.clear();
    for (auto& one : effect_probes_) one.clear();
    rest_since_.setConstant(std::numeric_limits<double>::infinity());
    rested_.setConstant(-std::numeric_limits<double>::infinity());
  }

  momentum_observer<M> observer_;
  controller<M, S, L> controller_;
  release_probe<d> probe_;  // for walls
  std::array<release_probe<d>, std::size_t(has_effects ? m : 0)> effect_probes_{};
  brake_lag_model expected_, actual_;  // torques of the unprobed and of the actual commands
  vector<double, m> counted_on_ = vector<double, m>::Zero();  // torques that the law assumes [N m]
  brake_vector<M> last_capacity_ = brake_vector<M>::Zero();
  brake_vector<M> assumed_hand_torque_ = brake_vector<M>::Zero();  // hand torque on each brake [N m]
  vector<double, m> rest_since_ = vector<double, m>::Constant(std::numeric_limits<double>::infinity());
  vector<double, m> rested_ =  // last time of each brake at rest [s]
      vector<double, m>::Constant(-std::numeric_limits<double>::infinity());
  std::array<bool, std::size_t(m)> probed_{};       // released by the probe of walls
  brake_vector<M> side_ = brake_vector<M>::Zero();  // sign of the last torque for effects
};

}  // namespace passive_haptics
