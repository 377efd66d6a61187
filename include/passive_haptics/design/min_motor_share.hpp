/// Motors that a device would need to hold a hand.
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/design/max_resistance.hpp>
#include <passive_haptics/design/path_point.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace passive_haptics {

/// Result of min_motor_share.
template <class T>
struct motor_share_result {
  /// ok, also if no motors hold the hand; else state_not_finite (q or the direction), contact_invalid (no
  /// normal), parameters_invalid (a limit that is not a finite number >= 0, or a NaN push), pose_undefined,
  /// singular_jacobian (redundant brakes only).
  status outcome = status::ok;
  /// Torque of each motor by the limit of its brake [1], >= 0; infinite if no motors suffice.
  T share = std::numeric_limits<T>::infinity();
};

namespace detail {

// Minimum share s >= 0 with  g(s) = sum over i of |w_i| max(u_i, s L_i) >= P, where brake i produces u_i
// against the rate w_i. g is convex and piecewise linear, so Newton's method from above ends exactly at the
// solution after at most m steps.
template <class T, int Brakes>
T min_share_against(const vector<T, Brakes>& rates, const torque_box<T, Brakes>& box,
                    const vector<T, Brakes>& limit, T push) {
  const T rounding = rounding_tolerance<T>(Brakes) * rates.cwiseAbs().maxCoeff();
  const vector<T, Brakes> w = (rates.array().abs() > rounding).select(rates, T(0)),
                          made = (w.array() > T(0)).select(box.upper, -box.lower);
  T share = push / limit.dot(w.cwiseAbs());  // upper bound: motors only
  for (int step = 0; step <= Brakes; ++step) {
    T by_brakes = T(0), by_motors = T(0);  // by_motors: for a share of 1
    for (int i = 0; i < Brakes; ++i) {
      const bool motor = share * limit[i] > made[i];
      (motor ? by_motors : by_brakes) += std::abs(w[i]) * (motor ? limit[i] : made[i]);
    }
    if (by_brakes >= push) return T(0);
    const T next = (push - by_brakes) / by_motors;
    if (!(next < share)) break;
    share = next;
  }
  return share;
}

}  // namespace detail

/// Returns the minimum motor for each brake, as a share of its torque limit, that holds a hand on the wall
/// (sink slope 0) when it pushes with `push` [N] and moves the end effector in `direction` at joint positions
/// q. 0 if the brakes suffice. Direction and normal: base frame, any length; only the direction's part along
/// the wall counts. Limits must be finite.
///
/// Motors of share s produce s_i t_i <= s limit_i (hybrid_brakes). By virtual work they hold the push if
/// motors and brakes together resist it on each motion into the wall (displayable):
///
///     sum over i of |w_i| max(torque of brake i against w_i, s limit_i) >= P    for all w with J qd = n.
///
/// For n = d there is one such motion. In general s is the maximum over these motions, and the minimum over
/// the sets of brakes that can come to rest. Above 1 the motors are stronger than the brakes. Never
/// allocates.
template <class M>
motor_share_result<typename M::scalar> min_motor_share(const M& mechanism, const joint_vector<M>& q,
                                                       const task_vector<M>& direction,
                                                       const task_vector<M>& normal,
                                                       const switchable_brakes<M>& brakes,
                                                       typename M::scalar push) {
  static_assert(is_mechanism<M, explain>());
  using T = typename M::scalar;
  motor_share_result<T> found;
  const hybrid_brakes<M> as_strong(brakes, brakes.torque_limit);
  found.outcome = detail::outcome_of<M>(q, direction, normal, as_strong);
  if (found.outcome == status::ok && (std::isnan(push) || !all_finite(brakes.torque_limit)))
    found.outcome = status::parameters_invalid;
  if (found.outcome != status::ok) return found;
  const brake_matrix<M> E(passive_haptics::brake_jacobian(mechanism, q));
  if (!all_finite(E)) {
    found.outcome = status::pose_undefined;
    return found;
  }
  const auto motions = form_of<M>::motions(mechanism, q, E, as_strong);
  found.outcome = motions.outcome();
  if (found.outcome != status::ok) return found;
  const task_vector<M> n = direction_of(normal), along = detail::along_wall(direction, n);
  motions.for_each([&](const auto& W) {
    const auto box = passive_haptics::torque_box_of(motions.signs(W, along), brakes);
    T largest = T(0);
    motions.for_each_way(n, [&](const brake_vector<M>& w) {
      largest = std::max(largest, detail::min_share_against(w, box, brakes.torque_limit, push));
    });
    found.share = std::min(found.share, largest);
  });
  return found;
}

/// Returns the minimum share that holds the push on a path, the maximum over its points; infinite if a point
/// has no result. path(u): path_point<M> at u in (0, 1). Throws std::invalid_argument for less than 1 sample.
template <class M, class Path>
typename M::scalar min_motor_share(const M& mechanism, Path&& path, const switchable_brakes<M>& brakes,
                                   typename M::scalar push, int samples = 200) {
  detail::refuse_unless(samples >= 1, "samples of a min_motor_share", samples, "1 or more");
  typename M::scalar largest = 0;
  for (int k = 0; k < samples; ++k) {
    const path_point<M> at = path((k + 0.5) / samples);
    largest =
        std::max(largest, min_motor_share(mechanism, at.q, at.direction, at.normal, brakes, push).share);
  }
  return largest;
}

}  // namespace passive_haptics
