/// @file
/// What brakes can display against a wall at all, while the handle moves in a direction: no law can do more.
#pragma once

#include <passive_haptics/design/max_resistance.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace passive_haptics {

/// What can be displayed against a wall of unit normal n (base frame, out of the wall).
template <class M>
struct displayable_force {
  using scalar = typename M::scalar;  ///< Scalar of the mechanism.

  /// ok; else the rest says that there is nothing: state_not_finite (q or the direction), contact_invalid
  /// (no normal), parameters_invalid (a limit), pose_undefined, singular_jacobian (redundant brakes
  /// only).
  status outcome = status::ok;
  /// none if no producible force has a component along n, at whatever angle: a cycle also
  /// stops at its max_approximation_angle.
  display_class display = display_class::none;
  /// gamma [rad] between n and the nearest producible force: 0 where n itself is one, pi / 2 where none is.
  scalar angle = std::numbers::pi_v<scalar> / scalar(2);
  /// Fc [N], the displayed force that makes 1 N out of the wall: along the nearest force, n . Fc = 1, with
  /// its rest the drag and the force aside. 0 where nothing is displayed.
  task_vector<M> nearest = task_vector<M>::Zero();
  /// Largest n . F [N] over all forces F that the brakes, and motors beside them, can make within their
  /// limits. Infinite where the structure itself holds, or a brake without limit.
  scalar max_force = scalar(0);
  /// Largest n . F [N] along the nearest force, by its own torques: what a force approximation, cut to the
  /// limits, displays at most.
  scalar max_approximated_force = scalar(0);
  /// s (m) of the brakes in this motion, once it has settled: -1, 0 or 1.
  brake_vector<M> signs = brake_vector<M>::Zero();
  /// S of the nearest force, a bit for each brake that comes to rest where a self-motion settles; else 0.
  brake_set held = 0;
};

namespace detail {

// Class, angle and max_approximated_force of the nearest force.
template <class M, class Force>
void describe(displayable_force<M>& found, const task_vector<M>& n, const Force& Fc,
              const switchable_brakes<M>& brakes) {
  found.display = Fc.display;
  if (!is_displayed(Fc.display)) return;
  found.nearest = Fc.force;
  const task_vector<M> Fp = Fc.cosine_squared * Fc.force;
  found.angle = std::atan2((n - Fp).norm(), Fp.norm());
  found.max_approximated_force = max_share(Fc.torque, brakes);
}

}  // namespace detail

/// What these brakes can display against a wall with normal n while the end effector moves in `direction`, at
/// joint positions q. Direction and normal: base frame, any length > 0; at rest the direction is zero. Of the
/// brakes the limits and intervals are read; limits may be infinite, and a brake whose limit is 0 is off.
///
/// The motion decides the signs: w = T J^+ v, s = sgn(w), and brake i makes s_i t_i <= 0 (3). A brake that
/// rests in this motion (|w_i| of rounding size) can hold either way, so s_i = 0. Of a direction that a
/// singular pose does not allow, the part that it does counts. With self-motion (n > d) the rates are those
/// once it has settled, with the brakes at rest that let most be displayed. More brakes than joints leave
/// nothing to assume.
///
/// The strongest normal force has any tangential part. By virtual work,
///
///     max n . F = min over joint rates with J qd = n of  sum_i max over |t_i| <= limit_i, s_i t_i <= 0 of
///                 t_i w_i,   w = T qd,
///
/// what brakes make against the easiest way into the wall. For n = d it is the sum over brakes of max(0,
/// n . g_i) limit_i, with g_i = -s_i G e_i (for s_i = 0 of |n . G e_i| limit_i). No law displays more; one
/// that chooses each torque displays that, force approximation gets to max_approximated_force. Where the
/// handle moves along the wall the rest of F is drag, never help: F . v = t . w <= 0. A handle that sinks
/// moves in another direction, in which more can be displayed (sink_slope).
///
/// Motors beside the brakes (hybrid_brakes) count in `max_force` alone, by s_i t_i <= motor_limit_i; class,
/// angle, signs and max_approximated_force are those of the brakes.
///
/// Never allocates. For looking at a device, not for a control cycle. Cost: a projection (approximate) and
/// one decomposition; at singular poses and with self-motion 2^m decompositions of d x m.
template <class M>
displayable_force<M> displayable(const M& mechanism, const joint_vector<M>& q,
                                 const task_vector<M>& direction, const task_vector<M>& normal,
                                 const hybrid_brakes<M>& brakes) {
  static_assert(is_mechanism<M, explain>());
  displayable_force<M> found;
  found.outcome = detail::outcome_of<M>(q, direction, normal, brakes);
  if (found.outcome != status::ok) return found;
  const brake_matrix<M> E(passive_haptics::brake_jacobian(mechanism, q));
  if (!all_finite(E)) {
    found.outcome = status::pose_undefined;
    return found;
  }
  const auto motions = form_of<M>::motions(mechanism, q, E, brakes.brakes);
  found.outcome = motions.outcome();
  if (found.outcome != status::ok) return found;
  const task_vector<M> v = direction_of(direction), n = direction_of(normal);
  const auto Fc = form_of<M>::nearest(motions, E, v, n, brakes.brakes, found.signs, found.held);
  detail::describe(found, n, Fc, brakes.brakes);
  if (brakes.has_motors())
    found.max_force = detail::max_force_in_motion(form_of<M>::motions(mechanism, q, E, brakes), v, n, brakes);
  else if (is_displayed(found.display)) found.max_force = detail::max_force_in_motion(motions, v, n, brakes);
  return found;
}

/// What brakes of these torque limits [N m] can display.
template <class M>
displayable_force<M> displayable(const M& mechanism, const joint_vector<M>& q,
                                 const task_vector<M>& direction, const task_vector<M>& normal,
                                 const brake_vector<M>& torque_limit = brake_vector<M>::Constant(
                                     std::numeric_limits<typename M::scalar>::infinity())) {
  return passive_haptics::displayable(mechanism, q, direction, normal,
                                      hybrid_brakes<M>::with_limits(torque_limit));
}

}  // namespace passive_haptics
