/// @file
/// One control cycle of W states at once: the paper's way of control/ways/one_wall.hpp, with masks in place
/// of branches. The formulas are those of the single cycle, for packs.
#pragma once

#include <passive_haptics/brake/passive_constraint.hpp>
#include <passive_haptics/control/batch/batch_results.hpp>
#include <passive_haptics/control/cycle.hpp>
#include <passive_haptics/core/flatten.hpp>
#include <passive_haptics/core/scalar/pack_sine_cosine.hpp>
#include <passive_haptics/scene/wall.hpp>

namespace passive_haptics {

/// The states of W devices.
template <class M, class T>
struct packed_state {
  vector<T, M::dof> q;                      ///< Joint positions [rad or m].
  vector<T, M::dof> qd;                     ///< Joint rates [rad/s or m/s].
  vector<T, M::task_dimension> hand_force;  ///< [N]
  T time;                                   ///< [s]
};

/// What step_result has, of W devices.
template <class M, class T>
struct packed_result {
  vector<T, M::brake_count> capacity;           ///< [N m]
  choice_of<T, status> outcome;                 ///< ok, or why the brakes were released.
  vector<T, M::brake_count> torque;             ///< [N m]
  choice_of<T, power_class> power;              ///< Of the desired force.
  choice_of<T, display_class> display;          ///< How it is displayed.
  choice_of<T, bool> saturated;                 ///< Whether a torque limit was reached.
  choice_of<T, int> wall_number;                ///< 0; -1 in free space.
  T alpha;                                      ///< (12)
  T approximation_cosine;                       ///< cos(gamma)
  vector<T, M::task_dimension> desired_force;   ///< Fd [N]
  vector<T, M::task_dimension> control_force;   ///< Fc [N]
  vector<T, M::brake_count> cone_coefficients;  ///< [N m]
  vector<T, M::brake_count> signs;              ///< s
};

namespace detail {

// x where it is true, else 0.
template <class T, int N, class Mask>
vector<T, N> or_zero(const Mask& where, const vector<T, N>& x) {
  vector<T, N> y;
  unrolled<N>([&](auto i) { y[i] = select(where, x[i], T(0)); });
  return y;
}

// What is known of W cycles.
template <class T>
struct packed_checks {
  truth_of<T> is_touched, is_demanded;
  truth_of<T> state_is_finite, x_is_finite, contact_is_valid, outward_is_finite, is_share, command_is_finite;

  // Nothing is wrong, whether a force is demanded or not.
  truth_of<T> are_passed() const {
    return state_is_finite & x_is_finite & contact_is_valid & outward_is_finite & is_share &
           command_is_finite;
  }
  // The status, in the order in which a single cycle checks. parameters: of brakes, law and options;
  // pose_is_checked: as is_usable_position does.
  choice_of<T, status> outcome(status parameters, bool pose_is_checked) const {
    const choice_of<T, status> ok = status::ok;
    const auto no_number = select(is_share, status::result_not_finite, status::scale_out_of_range);
    const auto no_pose = select(outward_is_finite, no_number, status::pose_undefined);
    const auto no_command = select(contact_is_valid, no_pose, status::contact_invalid);
    const auto command = select(outward_is_finite & is_share & command_is_finite, ok, no_command);
    const auto no_contact = select(x_is_finite, status::contact_invalid, status::pose_undefined);
    const auto no_force = select((!is_touched) | (x_is_finite & contact_is_valid), ok, no_contact);
    const auto at_x = select(is_demanded, command, no_force);
    const auto of_pose = pose_is_checked ? select(x_is_finite, at_x, status::pose_undefined) : at_x;
    return select(state_is_finite, parameters == status::ok ? of_pose : parameters, status::state_not_finite);
  }
};

}  // namespace detail

/// The cycle. Result: brake_command<M>, or step_result<M> for all that packed_result has. parameters: the
/// status of brakes, law and options.
template <class Result, class Setup, class Shape, class T>
PASSIVE_HAPTICS_PART packed_result<typename Setup::mechanism_type, T> packed_cycle(
    const Setup& setup, status parameters, const wall<Shape>& touchable,
    const packed_state<typename Setup::mechanism_type, T>& state) {
  namespace ph = passive_haptics;
  using M = typename Setup::mechanism_type;
  using L = typename Setup::law_type;
  using brake_pack = vector<T, M::brake_count>;
  constexpr bool has_account = requires(Result r) { r.torque; };
  packed_result<M, T> result;

  // Where the devices are and how deep in the wall
  const auto state_is_finite = all_finite(state.q, state.qd, state.hand_force, state.time);
  const mechanism_pose<M, T> pose(setup.mechanism, state.q);
  const auto x = pose.position();
  const T distance = touchable.shape.distance(x);
  const auto is_touched = !(distance >= T(0));
  const desired_force<T, M::task_dimension> Fd{touchable.shape.gradient(x),
                                               T(touchable.stiffness()) * -distance,
                                               vector<T, M::task_dimension>::Zero()};
  const auto is_demanded = is_touched & is_nonzero(Fd);

  // What the brakes can do: v = E w, t = E^T F, and the sign of each
  const auto E = setup.brake_jacobian(pose);
  const brake_pack w = pose.brake_rates(state.qd);
  const auto v = times(E, w);
  const brake_pack th = brake_torque(E, state.hand_force);
  const brake_pack s = ph::brake_signs(w, th, setup.brakes);

  // Section 4: Fc, alpha, Fc', td
  half_space_start start;
  const auto Fc = Fd.magnitude * approximate(E, s, Fd.direction, setup.options.min_cosine, start);
  const T leaving = outward(Fd, v);
  const T alpha = setup.law.scale(
      contact_situation<T, M::task_dimension>{Fd.direction, Fd.magnitude, leaving, state.hand_force});
  const auto Fc_scaled = alpha * Fc;
  saturated_torque<T, M::brake_count> td;
  if constexpr (saturates_before_scaling<L>)
    td = alpha * ph::within_limits(Fc.torque, setup.brakes, setup.options.limits);
  else td = ph::within_limits(Fc_scaled.torque, setup.brakes, setup.options.limits);

  // Which states have a command, and why the others have none
  detail::packed_checks<T> checks{is_touched,
                                  is_demanded,
                                  state_is_finite,
                                  all_finite(x),
                                  all_finite(Fd.magnitude, Fd.direction),
                                  all_finite(leaving),
                                  (alpha >= T(0)) & (alpha <= T(1)),
                                  true};
  if constexpr (has_account) checks.command_is_finite = all_finite(Fc.force, Fc.torque);
  else checks.command_is_finite = all_finite(Fc_scaled.torque);
  truth_of<T> is_ok = checks.are_passed();
  result.outcome = status::ok;
  if (!none(!is_ok) || parameters != status::ok) {
    result.outcome = checks.outcome(parameters, !detail::jacobian_is_constant<M>);
    is_ok = result.outcome == status::ok;
  }
  const auto is_commanded = is_ok & is_demanded;

  unrolled<M::brake_count>(
      [&](auto i) { result.capacity[i] = select(is_commanded, abs(td.torque[i]), T(0)); });
  if constexpr (has_account) {
    const brake_pack t = ph::passive_torque(td.torque, w, th, s, setup.brakes);
    result.torque = detail::or_zero(is_commanded, t);
    result.power =
        select(is_commanded, classify_power(Fd.direction.dot(v), Fc.display == display_class::exact),
               power_class::none);
    result.display =
        select(is_commanded, Fc.display, select(is_ok, display_class::exact, display_class::none));
    result.saturated = select(is_commanded & td.limited, true, false);
    result.wall_number = select(is_commanded, 0, -1);
    result.alpha = select(is_commanded, alpha, T(1));
    result.approximation_cosine = select(is_commanded, Fc.cosine(), T(1));
    result.desired_force =
        detail::or_zero(is_commanded, vector<T, M::task_dimension>(Fd.magnitude * Fd.direction));
    result.control_force = detail::or_zero(is_commanded, Fc.force);
    result.cone_coefficients = detail::or_zero(is_commanded, Fc.torque);
    result.signs = detail::or_zero(is_commanded, s);
  }
  return result;
}

}  // namespace passive_haptics
