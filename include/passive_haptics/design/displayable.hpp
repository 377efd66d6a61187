/// Forces that brakes can display against a wall during a motion, an upper bound for all laws.
#pragma once

#include <passive_haptics/design/max_resistance.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace passive_haptics {

/// Forces that can be displayed against a wall of outward unit normal n (base frame).
template <class M>
struct displayable_force {
  using scalar = typename M::scalar;  ///< Scalar of the mechanism.

  /// ok, or an error with no force: state_not_finite (q or the direction), contact_invalid (no normal),
  /// parameters_invalid (a limit), pose_undefined, singular_jacobian (redundant brakes only).
  status outcome = status::ok;
  /// none if no producible force has a component along n at any angle.
  display_class display = display_class::none;
  /// gamma [rad] between n and the nearest producible force: 0 if n itself is producible, pi / 2 if none is.
  scalar angle = std::numbers::pi_v<scalar> / scalar(2);
  /// Fc [N]: the nearest force, scaled to n . Fc = 1 N. 0 if nothing is displayed.
  task_vector<M> nearest = task_vector<M>::Zero();
  /// Maximum n . F [N] over all forces F that brakes and motors can produce within their limits. Infinite if
  /// the structure itself holds, or a brake without limit.
  scalar max_force = scalar(0);
  /// Maximum n . F [N] along the nearest force with its torques, the limit of a force approximation.
  scalar max_approximated_force = scalar(0);
  /// Signs s (m) of the brakes in this motion, once settled: -1, 0 or 1.
  brake_vector<M> signs = brake_vector<M>::Zero();
  /// S of the nearest force: bits of the brakes that come to rest if a self-motion settles; else 0.
  brake_set held = 0;
};

namespace detail {

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

/// Returns the forces that these brakes can display against a wall with normal n while the end effector moves
/// in `direction` at joint positions q. Direction and normal: base frame, any length > 0; the direction is
/// zero at rest. Uses the limits and intervals of the brakes; limits may be infinite, and 0 means off.
///
/// The motion determines the signs: w = T J^+ v, s = sgn(w), and brake i produces s_i t_i <= 0 (3). A brake
/// at rest in this motion (|w_i| of rounding size) can hold either way, s_i = 0. At a singular pose only the
/// feasible part of the direction counts. With self-motion (n > d) the rates are the settled ones, for the
/// brakes at rest that maximise the displayed force.
///
/// The maximum normal force may have any tangential part. By virtual work,
///
///     max n . F = min over joint rates with J qd = n of  sum_i max over |t_i| <= limit_i, s_i t_i <= 0 of
///                 t_i w_i,   w = T qd,
///
/// the resistance of the brakes to the easiest motion into the wall. For n = d it is the sum of max(0, n .
/// g_i) limit_i over the brakes, with g_i = -s_i G e_i (for s_i = 0: |n . G e_i| limit_i). No law displays
/// more. A law that chooses each torque reaches it; force approximation reaches max_approximated_force. For
/// motion along the wall the rest of F is drag, F . v = t . w <= 0. A sinking handle moves in another
/// direction, in which more can be displayed (sink_slope).
///
/// Motors (hybrid_brakes) only affect `max_force`, by s_i t_i <= motor_limit_i. Never allocates. For design,
/// not for a control cycle: at singular poses and with self-motion 2^m decompositions of d x m.
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

/// Overload for brakes with these torque limits [N m].
template <class M>
displayable_force<M> displayable(const M& mechanism, const joint_vector<M>& q,
                                 const task_vector<M>& direction, const task_vector<M>& normal,
                                 const brake_vector<M>& torque_limit = brake_vector<M>::Constant(
                                     std::numeric_limits<typename M::scalar>::infinity())) {
  return passive_haptics::displayable(mechanism, q, direction, normal,
                                      hybrid_brakes<M>::with_limits(torque_limit));
}

}  // namespace passive_haptics
