/// @file
/// One control cycle: the only place that chains the stages.
#pragma once

#include <passive_haptics/brake/brake_jacobian.hpp>
#include <passive_haptics/brake/passive_constraint.hpp>
#include <passive_haptics/control/control_law.hpp>
#include <passive_haptics/control/device_state.hpp>
#include <passive_haptics/control/saturation.hpp>
#include <passive_haptics/control/step_result.hpp>
#include <passive_haptics/force/approximation.hpp>
#include <passive_haptics/force/desired_force.hpp>
#include <passive_haptics/mechanism/dynamics.hpp>

#include <cmath>

namespace passive_haptics {

/// Options of a step; made once, outside the loop.
template <class T>
struct step_options {
  /// The defaults of approximation_parameters; torques keep their direction at a limit.
  step_options() = default;
  /// Throws std::invalid_argument with the text of validate(approximation).
  explicit step_options(const approximation_parameters<T>& approximation,
                        saturation on_limit = saturation::keep_direction)
      : min_cosine(std::cos(require_valid(approximation).max_approximation_angle)), limits(on_limit) {}

  T min_cosine = T(0.0174524064372835128L);        ///< Cosine of the largest approximation angle, 89 deg.
  saturation limits = saturation::keep_direction;  ///< What gives way at a torque limit.
};

/// What a step remembers; start a motion with a fresh one.
template <class L>
struct step_memory {
  static_assert(ControlLaw<L>, "passive_haptics: the law must model ControlLaw (control/control_law.hpp).");
  [[no_unique_address]] typename L::memory law = {};  ///< The law's own part.
};

/// Whether NaN or infinity stands in the parts of a state that law L reads.
template <class L, class M, class State>
status check_state(const State& state) {
  bool finite = std::isfinite(state.time) && all_finite(state.q) && all_finite(state.qd);
  if constexpr (HandForceState<State, M>) finite = finite && all_finite(state.hand_force);
  return finite ? status::ok : status::state_not_finite;
}

/// One control cycle of a mechanism in contact: from what is touched and how the device moves to what the
/// brakes are told. Pure apart from memory; never throws, allocates, locks or reads a clock.
///
/// Of several contacts the one that asks for the largest force governs, the others are ignored.
/// If the state has no hand force, a brake at rest has sign 0: it may hold either way.
///
/// Errors: NaN or infinity in what is read, a pose without a finite Jacobian or a law's scale outside [0, 1] gives
/// zero capacity and the reason in outcome. Cost: nothing but checks in free space; no projection where Fd can be displayed exactly.
template <class M, class Contacts, class L, class State>
step_result<M> step(
    const M& mechanism, const brakes_of<M>& brakes, const Contacts& touched, const L& law, const State& state,
    step_memory<L>& memory,
    const step_options<typename M::scalar>& options = step_options<typename M::scalar>()) noexcept {
  static_assert(mechanism_requirements<M>::met);
  static_assert(DeviceState<State, M>,
                "passive_haptics: the state must be a device_state<M>, or have its members "
                "time, q and qd with exactly its types.");
  static_assert(
      !L::needs_hand_force || HandForceState<State, M>,
      "passive_haptics: this law needs a hand force: give the state a hand_force (device_state<M>), or "
      "take a law that needs none (no_direct_control).");
  static_assert(!L::needs_dynamics || Dynamics<M>,
                "passive_haptics: this law needs a mechanism that models Dynamics (mechanism/dynamics.hpp).");
  static_assert(Contacts::dimension == M::task_dimension,
                "passive_haptics: the scene's dimension must be the mechanism's task_dimension.");
  using T = typename M::scalar;
  constexpr bool feels_hand = HandForceState<State, M>;

  step_result<M> result;
  if (const status s = check_state<L, M>(state); s != status::ok) return released_by<M>(s);
  if (touched.empty()) return result;

  bool known = all_finite(brakes.torque_limit) && all_finite(brakes.rate_dead_band) &&
               all_finite(brakes.torque_dead_band);
  if constexpr (L::needs_brake_lag) known = known && all_finite(brakes.time_constant);
  if (!known) return released_by<M>(status::parameters_not_finite);

  // Desired force, as a unit force n and a magnitude
  const auto& contact = touched[governing_contact(touched)];
  const auto [n, magnitude] = force_of<T>(contact);
  const auto v_wall = contact.wall_velocity.template cast<T>().eval();
  if (!std::isfinite(magnitude) || !all_finite(n) || !all_finite(v_wall))
    return released_by<M>(status::contact_not_finite);
  result.wall = contact.wall;
  if (!(magnitude > T(0))) return result;
  result.desired_force = magnitude * n;

  // What the brakes can do: E, their rates and signs
  const auto E = brake_jacobian(mechanism, state.q);
  const brake_vector<M> w = brake_rates(mechanism, state.q, state.qd);
  result.stages.add(stage::jacobian);
  if (!all_finite(E) || !all_finite(w)) return released_by<M>(status::pose_undefined);

  brake_vector<M> th = brake_vector<M>::Zero();
  if constexpr (feels_hand) {
    if (any_sticks(w, brakes)) {
      th = brake_torque(E, state.hand_force);
      result.stages.add(stage::hand_torque);
    }
  }
  const brake_vector<M> s = result.signs = brake_signs(w, th, brakes);
  result.stages.add(stage::signs);

  // Approximation
  const brake_vector<M> t = brake_torque(E, n);
  const T outward = t.dot(w);  // n . v = n . E w
  const auto Fc = approximate(E, s, n, t, options.min_cosine);
  result.power = classify_power(outward, s, t);
  result.display = Fc.display;
  result.approximation_cosine = Fc.cosine;
  if (Fc.display != display_class::exact) result.stages.add(stage::projection);
  if (Fc.display == display_class::none) return result;

  // The law's share of it, within the limits
  const task_vector<M> no_force = task_vector<M>::Zero();
  const task_vector<M>* Fh = &no_force;
  if constexpr (feels_hand && L::needs_hand_force) Fh = &state.hand_force;
  result.alpha = law.scale(
      contact_situation<T, M::task_dimension>{n, magnitude, outward - n.dot(v_wall), *Fh}, memory.law);
  result.stages.add(stage::law);
  if (!(result.alpha >= T(0) && result.alpha <= T(1))) return released_by<M>(status::scale_out_of_range);
  result.control_force = magnitude * Fc.force;
  result.cone_coefficients = magnitude * Fc.torque;

  const auto command = saturate(Fc.torque, result.alpha * magnitude, brakes.torque_limit, options.limits);
  if (!all_finite(command.torque) || !all_finite(result.control_force))
    return released_by<M>(status::result_not_finite);
  result.saturated = command.limited;
  result.capacity = command.torque.cwiseAbs();
  result.torque = passive_torque(command.torque, w, th, brakes);
  return result;
}

}  // namespace passive_haptics
