/// Inputs of a control cycle, and their checks.
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
struct any_time {};
}  // namespace detail

/// Memory of a step between cycles. Start a motion with a new one.
template <class L>
struct step_memory {
  [[no_unique_address]] law_memory<L> law = {};  ///< Memory of the law.
  approximation_start start = {};                ///< Start of the next approximation.
  /// Time of the last cycle, if the law uses time differences.
  [[no_unique_address]] std::conditional_t<needs_rising_time<L>, rising_time, detail::any_time> time = {};
};

/// Fixed inputs of a cycle, owned by a controller or given to step().
template <class M, class B, class L>
struct cycle_setup {
  using mechanism_type = M;  ///< Mechanism type.
  using law_type = L;        ///< Law type.

  const M& mechanism;                                 ///< Mechanism.
  const B& brakes;                                    ///< Brakes.
  const L& law;                                       ///< Control law.
  const brake_jacobian_evaluator<M>& brake_jacobian;  ///< E of the mechanism.
  const step_options<typename M::scalar>& options;    ///< Options.
};

/// The walls touched at x [m], from a scene or given directly.
template <class S, int D>
decltype(auto) walls_at(S& scene, const point<D>& x, double time) {
  if constexpr (requires { sense(scene, x, time); }) return sense(scene, x, time);
  else if constexpr (requires { sense(scene, x); }) return sense(scene, x);
  else return (scene);
}

/// Requests contacts from the law's margin on, if scene and law support it.
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

/// Contacts type of a scene, or contacts themselves.
template <class S>
using contacts_of = typename detail::contacts_given<S>::type;

/// v [m/s]: E w, or J qd if joints without a brake may move.
template <class M, class EMatrix>
task_vector<M> velocity_of(const mechanism_pose<M>& pose, const EMatrix& E, const brake_vector<M>& w,
                           const joint_vector<M>& qd) {
  if constexpr (M::brake_count < M::dof) return pose.velocity(qd);
  else return times(E, w);
}

/// Fh [N]; zero if the state has none.
template <class M, class State>
task_vector<M> hand_force(const State& state) {
  if constexpr (HandForceState<State, M>) return state.hand_force;
  else return task_vector<M>::Zero();
}

/// Hand torque on the brake axes [N m]: that of the state, or E^T Fh; zero if unknown or if brakes always
/// slip.
template <class M, class State, class EMatrix, class B>
brake_vector<M> hand_torque(const State& state, const EMatrix& E, const B&) {
  if constexpr (!StickingBrakes<B, typename M::scalar, M::brake_count>) return brake_vector<M>::Zero();
  else if constexpr (HandTorqueState<State, M>) return state.hand_torque;
  else if constexpr (HandForceState<State, M>) return brake_torque(E, state.hand_force);
  else return brake_vector<M>::Zero();
}

/// state_not_finite if the state contains NaN or infinity, else ok.
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

/// Checks that the time of a state [s] increases, if the law uses time differences, and stores it.
template <class L>
status check_time([[maybe_unused]] double time, [[maybe_unused]] step_memory<L>& memory) {
  if constexpr (needs_rising_time<L>) return memory.time.next(time);
  else return status::ok;
}

namespace detail {
template <class L>
bool has_valid_members([[maybe_unused]] const L& law) {
  if constexpr (Parameters<L>) return is_in_range(law);
  else if constexpr (requires { law.parameters; }) return has_valid_members(law.parameters);
  else return true;
}
}  // namespace detail

/// parameters_invalid if a used parameter of the brakes, the law or the options is out of range, else ok.
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

/// A scene with a sense() that changes it.
template <class S, int D>
concept RemembersHandle = !requires(const S& fixed, const point<D>& x) { sense(fixed, x); } &&
                          (requires(S& scene, const point<D>& x) { sense(scene, x); } ||
                           requires(S& scene, const point<D>& x) { sense(scene, x, 0.0); });

/// False if a position is not finite. Only checked if J is not constant or the scene could remember it.
template <class M, class S, int D>
bool is_usable_position(const S&, const point<D>& x) {
  if constexpr (RemembersHandle<S, D> || !detail::jacobian_is_constant<M>) return all_finite(x);
  else return true;
}

}  // namespace passive_haptics
