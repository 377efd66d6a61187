/// @file
/// One control cycle: the only place that chains the stages.
#pragma once

#include <passive_haptics/brake/passive_constraint.hpp>
#include <passive_haptics/control/device_state.hpp>
#include <passive_haptics/control/one_contact.hpp>
#include <passive_haptics/control/several_contacts.hpp>
#include <passive_haptics/control/torque_command.hpp>
#include <passive_haptics/core/flatten.hpp>

#include <cmath>

namespace passive_haptics {

/// Whether NaN or infinity stands in a state.
template <class M, class State>
status check_state(const State& state) {
  bool finite;
  if constexpr (HandForceState<State, M>)
    finite = all_finite(state.q, state.qd, state.hand_force, state.time);
  else finite = all_finite(state.q, state.qd, state.time);
  return finite ? status::ok : status::state_not_finite;
}

/// Whether what a step reads of the brakes and the options is finite and no limit or dead band negative. The
/// lag is read by laws that need it.
template <class L, class T, class B>
status check_parameters([[maybe_unused]] const B& brakes, const step_options<T>& options) {
  const auto valid_each = [](const auto& x) { return all_finite(x) && (x.array() >= T(0)).all(); };
  bool valid = all_finite(options.min_cosine);
  if constexpr (detail::names_torque_limit<B>) valid = valid && valid_each(brakes.torque_limit);
  if constexpr (detail::names_rate_dead_band<B>) valid = valid && valid_each(brakes.rate_dead_band);
  if constexpr (detail::names_torque_dead_band<B>) valid = valid && valid_each(brakes.torque_dead_band);
  if constexpr (L::needs_brake_lag) valid = valid && all_finite(brakes.time_constant);
  return valid ? status::ok : status::parameters_invalid;
}

namespace detail {

// What must hold of the brakes of a step under this law, one short message for each.
template <class M, class L, class B>
struct law_brake_requirements {
  static_assert(brake_requirements<B, M>::met);
  static_assert(!L::needs_brake_lag || names_time_constant<B>,
                "passive_haptics: this law needs the brakes' lag: give the brakes a time_constant "
                "(brake_parameters), or take a law that needs none.");
  static_assert(!needs_torque_limit<L> || names_torque_limit<B>,
                "passive_haptics: this law locks brakes: give the brakes a torque_limit (brake_parameters).");
  static constexpr bool met = true;
};

// What must hold of the types of a step, one short message for each.
template <class M, class Contacts, class L, class State, class B>
struct step_requirements {
  static_assert(mechanism_requirements<M>::met);
  static_assert(law_brake_requirements<M, L, B>::met);
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
  static constexpr bool met = true;
};

// Tells a law that asks for it that this cycle commanded nothing.
template <class L>
void tell_released(const L& law, typename L::memory& memory, double time) {
  if constexpr (requires { law.released(memory, time); }) law.released(memory, time);
}

// All of a step but the checks of what a loop knows to be fine: state and parameters; touched is not empty.
// result is as made by default; where the status is not ok it has no meaning.
template <step_knowledge Known, class M, class Pose, class B, class Contacts, class L, class State>
PASSIVE_HAPTICS_FLATTEN status step_in_contact(const M& mechanism, const Pose& at,
                                               const point<M::task_dimension>& x,
                                               const brake_jacobian_evaluator<M>& reduction, const B& brakes,
                                               const Contacts& touched, const L& law, const State& state,
                                               step_memory<L>& memory,
                                               const step_options<typename M::scalar>& options,
                                               step_result_for<M, Contacts>& result) noexcept {
  using T = typename M::scalar;
  constexpr bool feels_hand = HandForceState<State, M>;
  constexpr bool may_stick = StickingBrakes<B, T, M::brake_count>;

  const auto& governing = touched[governing_contact(touched)];
  const auto [n, magnitude] = force_of<T>(governing);
  result.wall = governing.wall;
  if (!(magnitude > T(0))) {
    tell_released(law, memory.law, state.time);
    return check_contacts<T>(touched);
  }
  result.desired_force = scaled(magnitude, n);

  // What the brakes can do: E, their rates and signs
  const auto E = reduction(jacobian(mechanism, at), mechanism, state.q);
  const brake_vector<M> w = brake_rates(mechanism, state.q, state.qd);
  result.stages.add(stage::jacobian);
  brake_vector<M> th = brake_vector<M>::Zero();
  if constexpr (feels_hand && may_stick) {
    if (any_sticks(w, brakes)) {
      th = brake_torque(E, state.hand_force);
      result.stages.add(stage::hand_torque);
    }
  }
  const brake_vector<M> s = brake_signs(w, th, brakes);
  result.signs = s;
  result.stages.add(stage::signs);

  // What the law wants of each contact, and the torques that come nearest to it
  task_vector<M> Fh = task_vector<M>::Zero();
  if constexpr (feels_hand && L::needs_hand_force) Fh = state.hand_force;
  const brake_situation<M, decltype(E), B> situation{mechanism, brakes, state.time, state.q, state.qd,
                                                     x,         E,      w,          s,       Fh};
  brake_vector<M> td;
  if constexpr (TorqueLaw<L>) {
    td = command_torques(situation, touched, law, memory.law, result);
  } else if constexpr (Contacts::capacity > 1) {
    td = touched.size() > 1 ? display_several<Known>(situation, touched, law, memory.law, result)
                            : display_one<Known>(situation, governing, law, memory, options, result);
  } else {
    td = display_one<Known>(situation, governing, law, memory, options, result);
  }
  if (result.outcome != status::ok) return result.outcome;
  if (!all_finite(result.control_force, result.cone_coefficients)) return status::result_not_finite;
  unrolled<M::brake_count>([&](auto i) { result.capacity[i] = std::abs(td[i]); });
  result.torque = passive_torque(td, w, th, s, brakes);
  return status::ok;
}

}  // namespace detail

/// One control cycle of a mechanism in contact: from what is touched and how the device moves to what the
/// brakes are told. Pure apart from memory; never throws, allocates, locks or reads a clock.
///
/// One contact is displayed by force approximation (one_contact.hpp), several by priorities
/// (several_contacts.hpp). If the state has no hand force, a brake at rest has sign 0: it may hold either
/// way.
///
/// B: brakes_of<M>, or any type with some of its members (brake/brake_concepts.hpp). Without a torque_limit
/// nothing is cut; without a rate_dead_band s = sgn(w) and no hand torque is computed.
///
/// Errors: NaN or infinity in what is read, a pose without a finite Jacobian or a law's scale outside [0, 1]
/// gives zero capacity and the reason in outcome. Cost: nothing but checks in free space; no projection where
/// Fd can be displayed exactly. A constant transmission is inverted each time; a controller keeps its
/// inverse.
template <class M, class Contacts, class L, class State, class B = brakes_of<M>>
step_result_for<M, Contacts> step(
    const M& mechanism, const B& brakes, const Contacts& touched, const L& law, const State& state,
    step_memory<L>& memory,
    const step_options<typename M::scalar>& options = step_options<typename M::scalar>()) noexcept {
  static_assert(detail::step_requirements<M, Contacts, L, State, B>::met);
  step_result_for<M, Contacts> result;
  status outcome = check_state<M>(state);
  const bool free = outcome == status::ok && touched.empty();
  if (outcome == status::ok && !free) outcome = check_parameters<L>(brakes, options);
  if (outcome == status::ok && !free) {
    const auto at = pose(mechanism, state.q);
    const auto x = as<double>(mechanism.position(at));
    outcome =
        detail::step_in_contact<step_knowledge{}>(mechanism, at, x, brake_jacobian_evaluator<M>(mechanism),
                                                  brakes, touched, law, state, memory, options, result);
  }
  if (outcome != status::ok) release(result, outcome);
  if (free || outcome != status::ok) detail::tell_released(law, memory.law, state.time);
  return result;
}

}  // namespace passive_haptics
