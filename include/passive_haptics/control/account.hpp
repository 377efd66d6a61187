/// @file
/// What stands around a control cycle: what may not enter it, why it ends without a command, what it tells.
#pragma once

#include <passive_haptics/control/stages.hpp>
#include <passive_haptics/control/step_result.hpp>

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

/// Whether what a cycle reads of the brakes and the options is finite and no limit or dead band negative.
template <class L, class T, class B>
status check_parameters([[maybe_unused]] const B& brakes, const step_options<T>& options) {
  const auto valid_each = [](const auto& x) { return all_finite(x) && (x.array() >= T(0)).all(); };
  bool valid = all_finite(options.min_cosine);
  if constexpr (detail::names_torque_limit<B>) valid = valid && valid_each(brakes.torque_limit);
  if constexpr (detail::names_rate_dead_band<B>) valid = valid && valid_each(brakes.rate_dead_band);
  if constexpr (detail::names_torque_dead_band<B>) valid = valid && valid_each(brakes.torque_dead_band);
  if constexpr (needs_brake_lag<L>) valid = valid && all_finite(brakes.time_constant);
  return valid ? status::ok : status::parameters_invalid;
}

/// Whether a scene remembers what it was shown: sense() changes it.
template <class S, int D>
concept RemembersHandle = !requires(const S& fixed, const point<D>& x) { sense(fixed, x); } &&
                          (requires(S& scene, const point<D>& x) { sense(scene, x); } ||
                           requires(S& scene, const point<D>& x) { sense(scene, x, 0.0); });

/// False for a position that is not finite. Not looked for where it costs more than it tells: where J is
/// constant finite q gives finite x, unless the scene would remember one that overflowed.
template <class M, class S, int D>
bool may_be_shown(const S&, const point<D>& x) {
  if constexpr (RemembersHandle<S, D> || !detail::jacobian_is_constant<M>) return all_finite(x);
  else return true;
}

/// What a scene says of itself: ok, or that it is out of date.
template <class S>
status status_of(const S& scene) {
  if constexpr (requires { scene_status(scene); }) return scene_status(scene);
  else return status::ok;
}

/// Why no force is asked for: ok in free space, else what is wrong with the position or a contact.
template <class M, int D, class Walls>
status reason(const point<D>& x, const Walls& touched) {
  if (touched.empty()) return status::ok;
  return all_finite(x) ? check_contacts<typename M::scalar>(touched) : status::pose_undefined;
}

/// Tells a law that asks for it that this cycle commands nothing.
template <class L>
void tell_released(const L& law, double time, step_memory<L>& memory) {
  if constexpr (requires { law.released(memory.law, time); }) law.released(memory.law, time);
}

/// All brakes released: in free space, or for a fault.
template <class Answer, class M, class B, class L>
Answer released(const cycle_parts<M, B, L>& with, double time, status outcome, step_memory<L>& memory) {
  tell_released(with.law, time, memory);
  return released<Answer>(outcome);
}

/// ok, or why these numbers are no command. All that went into a cycle has left its NaN in one of them.
/// is_share: whether the law's scale is in [0, 1].
template <class T, class Contacts, class Outward, class... Numbers>
status check_command(const Contacts& touched, const Outward& outward, bool is_share,
                     const Numbers&... command) {
  if (is_share && all_finite(outward, command...)) return status::ok;
  if (check_contacts<T>(touched) != status::ok) return status::contact_not_finite;
  if (!all_finite(outward)) return status::pose_undefined;
  return is_share ? status::result_not_finite : status::scale_out_of_range;
}

/// How Fd is displayed: where it is not, whether any force could be. That is a question of self-motion.
template <class M, class Now, class Force>
display_class display_of(const Now& now, const Force& Fc) {
  if constexpr (M::dof > M::task_dimension && !has_inertial_forces<M>)
    if (Fc.display == display_class::none && cone_is_zero(now.E, now.s)) return display_class::empty_cone;
  return Fc.display;
}

namespace detail {
// The wall that asks for most.
template <class Walls>
int wall_of(const Walls& touched) {
  if constexpr (Walls::capacity == 1) return touched[0].wall;
  else return touched[governing_contact(touched)].wall;
}

// The account of a cycle that went well.
template <class Answer, class M, class Now, class Walls, int D, class T, class Force, int Brakes>
Answer told(const Now& now, const Walls& touched, const desired_force<T, D>& Fd, const Force& Fc, T alpha,
            const saturated_torque<T, Brakes>& td, const brake_vector<M>& t) {
  Answer answer;
  answer.outcome = status::ok;
  answer.capacity = td.torque.cwiseAbs();
  if constexpr (requires { answer.torque; }) {
    answer.torque = t;
    answer.power = classify_power(Fd.direction.dot(now.v), Fc.display == display_class::exact);
    answer.display = display_of<M>(now, Fc);
    answer.saturated = td.limited;
    answer.wall = wall_of(touched);
    answer.alpha = alpha;
    answer.approximation_cosine = Fc.cosine();
    answer.desired_force = Fd.magnitude * Fd.direction;
    answer.control_force = Fc.force;
    answer.cone_coefficients = Fc.torque;
    answer.signs = now.s;
  }
  return answer;
}
}  // namespace detail

/// What the driver or a reader wants of a cycle that went so. What Answer lacks is not computed.
/// Fc: what was to be displayed of Fd, before alpha and limits.
template <class Answer, class M, class B, ScalingLaw L, class Now, class Walls, int D, class T, class Force,
          int Brakes>
Answer account(const cycle_parts<M, B, L>&, const Now& now, const Walls& touched,
               const desired_force<T, D>& Fd, const Force& Fc, T alpha, const Force& Fc_scaled,
               const saturated_torque<T, Brakes>& td, const brake_vector<M>& t, step_memory<L>&) {
  const bool is_share = alpha >= T(0) && alpha <= T(1);
  const T leaving = outward(Fd, now.v);
  status outcome;
  if constexpr (requires(Answer answer) { answer.control_force; })  // not smaller than Fc_scaled
    outcome = check_command<T>(touched, leaving, is_share, Fc.force, Fc.torque);
  else outcome = check_command<T>(touched, leaving, is_share, Fc_scaled.torque);
  return outcome == status::ok ? detail::told<Answer, M>(now, touched, Fd, Fc, alpha, td, t)
                               : released<Answer>(outcome);
}

}  // namespace passive_haptics
