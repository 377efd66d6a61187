/// @file
/// What a control cycle works with, and the checks of it.
#pragma once

#include <passive_haptics/brake/brake_jacobian.hpp>
#include <passive_haptics/control/control_law.hpp>
#include <passive_haptics/control/device_state.hpp>
#include <passive_haptics/control/rising_time.hpp>
#include <passive_haptics/control/step_options.hpp>
#include <passive_haptics/core/finite.hpp>
#include <passive_haptics/core/status.hpp>
#include <passive_haptics/force/approximation.hpp>
#include <passive_haptics/scene/contacts.hpp>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace passive_haptics {

namespace detail {
// In place of a time that is not compared.
struct any_time {};
}  // namespace detail

/// What a step remembers; start a motion with a fresh one.
template <class L>
struct step_memory {
  [[no_unique_address]] law_memory<L> law = {};  ///< The law's own part.
  approximation_start start = {};                ///< Where the next approximation begins.
  /// Of the last cycle, if the law uses time differences.
  [[no_unique_address]] std::conditional_t<needs_rising_time<L>, rising_time, detail::any_time> time = {};
};

/// What stays from cycle to cycle, but for the scene and the memory: owned by a controller, given to step().
template <class M, class B, class L>
struct cycle_setup {
  using mechanism_type = M;  ///< Of the mechanism.
  using law_type = L;        ///< Of the law.

  const M& mechanism;                                 ///< The mechanism.
  const B& brakes;                                    ///< Its brakes.
  const L& law;                                       ///< The control law.
  const brake_jacobian_evaluator<M>& brake_jacobian;  ///< Of the mechanism.
  const step_options<typename M::scalar>& options;    ///< Options.
};

/// The walls touched at x [m]: of a scene, or given as they are.
template <class S, int D>
decltype(auto) walls_at(S& scene, const point<D>& x, double time) {
  if constexpr (requires { sense(scene, x, time); }) return sense(scene, x, time);
  else if constexpr (requires { sense(scene, x); }) return sense(scene, x);
  else return (scene);
}

/// Lets a scene give contacts from the law's margin on, where both have one.
template <class S, class L, class B>
void see_ahead([[maybe_unused]] S& scene, [[maybe_unused]] const L& law, [[maybe_unused]] const B& brakes) {
  if constexpr (SeesAhead<S> && has_margin<L, B>) scene.set_margin(law.margin(brakes));
}

namespace detail {
template <class S>
struct contacts_given : std::type_identity<S> {};
template <class S>
  requires requires { typename S::contacts_type; }
struct contacts_given<S> : std::type_identity<typename S::contacts_type> {};
}  // namespace detail

/// The contacts that a scene gives; contacts give themselves.
template <class S>
using contacts_of = typename detail::contacts_given<S>::type;

/// v [m/s]: E w, but J qd where joints without a brake move, too.
template <class M, class EMatrix>
task_vector<M> velocity_of(const mechanism_pose<M>& pose, const EMatrix& E, const brake_vector<M>& w,
                           const joint_vector<M>& qd) {
  if constexpr (M::brake_count < M::dof) return pose.velocity(qd);
  else return times(E, w);
}

/// Fh [N]; zero where the state has none.
template <class M, class State>
task_vector<M> hand_force(const State& state) {
  if constexpr (HandForceState<State, M>) return state.hand_force;
  else return task_vector<M>::Zero();
}

/// The hand's torque on the brakes' axes [N m], which decides the signs of those at rest: that of the state,
/// or E^T Fh; zero where nobody measures the hand, or no brake is ever at rest.
template <class M, class State, class EMatrix, class B>
brake_vector<M> hand_torque(const State& state, const EMatrix& E, const B&) {
  if constexpr (!StickingBrakes<B, typename M::scalar, M::brake_count>) return brake_vector<M>::Zero();
  else if constexpr (HandTorqueState<State, M>) return state.hand_torque;
  else if constexpr (HandForceState<State, M>) return brake_torque(E, state.hand_force);
  else return brake_vector<M>::Zero();
}

/// Whether NaN or infinity stands in a state.
template <class M, class State>
status check_state(const State& state) {
  bool finite;
  if constexpr (HandTorqueState<State, M>)
    if (!all_finite(state.hand_torque)) return status::state_not_finite;
  if constexpr (HandForceState<State, M>)
    finite = all_finite(state.q, state.qd, state.hand_force, state.time);
  else finite = all_finite(state.q, state.qd, state.time);
  return finite ? status::ok : status::state_not_finite;
}

/// Whether the time of a state [s] rises, for a law that uses time differences. It is remembered.
template <class L>
status check_time([[maybe_unused]] double time, [[maybe_unused]] step_memory<L>& memory) {
  if constexpr (needs_rising_time<L>) return memory.time.next(time);
  else return status::ok;
}

namespace detail {
// Whether each parameter of a law is in its range: of itself, or of its member `parameters`.
template <class L>
bool has_valid_members([[maybe_unused]] const L& law) {
  if constexpr (Parameters<L>) return is_in_range(law);
  else if constexpr (requires { law.parameters; }) return has_valid_members(law.parameters);
  else return true;
}
}  // namespace detail

/// Whether what a cycle reads of the brakes, the law and the options is in its range.
template <class T, class B, class L>
status check_parameters([[maybe_unused]] const B& brakes, const L& law, const step_options<T>& options) {
  const auto valid_each = [](const auto& x) { return all_finite(x) && (x.array() >= T(0)).all(); };
  bool valid = all_finite(options.min_cosine) && detail::has_valid_members(law);
  if constexpr (detail::names_torque_limit<B>) valid = valid && valid_each(brakes.torque_limit);
  if constexpr (detail::names_torque_interval<B>)
    valid =
        valid && (brakes.torque_lower.array() <= T(0)).all() && (brakes.torque_upper.array() >= T(0)).all();
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

/// False for a position that is not finite. True unchecked where J is constant, as finite q then gives finite
/// x, unless the scene would remember one that overflowed.
template <class M, class S, int D>
bool is_usable_position(const S&, const point<D>& x) {
  if constexpr (RemembersHandle<S, D> || !detail::jacobian_is_constant<M>) return all_finite(x);
  else return true;
}

}  // namespace passive_haptics
