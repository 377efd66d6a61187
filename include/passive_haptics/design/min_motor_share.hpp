/// @file
/// How much motor beside each brake a device would need to hold a hand.
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/design/max_resistance.hpp>
#include <passive_haptics/design/path_point.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace passive_haptics {

/// A share of motors, or why there is none.
template <class T>
struct motor_share_result {
  /// ok, also where no motors hold the hand; else state_not_finite (q or the direction), contact_invalid (no
  /// normal), parameters_invalid (a limit that is no finite number >= 0, or a push that is NaN),
  /// pose_undefined, singular_jacobian (redundant brakes only).
  status outcome = status::ok;
  /// Torque of each motor for the torque limit of its brake [1], >= 0. Infinite where no motors are enough,
  /// and where there is no result.
  T share = std::numeric_limits<T>::infinity();
};

namespace detail {

// Least share s >= 0 with  g(s) = sum over i of |w_i| max(u_i, s L_i) >= P, u_i being what brake i makes
// against the rate w_i. g is convex and linear between the shares at which a motor becomes stronger than what
// its brake makes, so Newton's method from above ends at the solution itself, after m steps at most.
template <class T, int Brakes>
T min_share_against(const vector<T, Brakes>& rates, const torque_box<T, Brakes>& box,
                    const vector<T, Brakes>& limit, T push) {
  const T rounding = rounding_tolerance<T>(Brakes) * rates.cwiseAbs().maxCoeff();
  const vector<T, Brakes> w = (rates.array().abs() > rounding).select(rates, T(0)),
                          made = (w.array() > T(0)).select(box.upper, -box.lower);
  T share = push / limit.dot(w.cwiseAbs());  // by the motors alone, at least what is needed
  for (int step = 0; step <= Brakes; ++step) {
    T by_brakes = T(0), by_motors = T(0);  // the second for a share of 1
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

/// Least motor beside each brake, as a share of its torque limit, with which a hand is held on the wall, at
/// sink slope 0. It pushes with `push` [N] and leads the end effector in `direction` at joint positions q. 0
/// where brakes alone hold it. Direction and normal: base frame, any length; of the direction the part along
/// the wall counts. Limits are finite: there is no share of a limit without bound.
///
/// Motors of share s make s_i t_i <= s limit_i (hybrid_brakes). By virtual work they hold the push where
/// their torques and the brakes' resist it on each way into the wall (displayable):
///
///     sum over i of |w_i| max(what brake i makes against w_i, s limit_i) >= P    for all w with J qd = n.
///
/// For n = d there is one way, and s = (P - F) / (what the brakes would make that cannot push out), F the
/// strongest normal force of brakes alone. In general it is the largest over the ways of the easiest motion,
/// and the least over the sets of brakes that can come to rest. Over 1 the motors are stronger than the
/// brakes.
///
/// Never allocates. Cost: that of sink_slope.
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

/// Least share with which the push is held everywhere on a path: the largest of its places. Infinite where
/// one has no result. path(u) returns the path_point<M> at u in (0, 1). Called at the middles of `samples`
/// equal parts. Throws std::invalid_argument for less than 1 sample. Cost: that of sink_slope for each.
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
