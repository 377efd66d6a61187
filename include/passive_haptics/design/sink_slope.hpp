/// @file
/// How steeply a hand sinks into a wall that brakes cannot display.
#pragma once

#include <passive_haptics/design/max_resistance.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace passive_haptics {

/// A sink slope, or why there is none.
template <class T>
struct sink_slope_result {
  /// ok, also where nothing holds the hand; else state_not_finite (q or the direction), contact_invalid (no
  /// normal), parameters_invalid (a limit, or a push that is NaN), pose_undefined, singular_jacobian
  /// (redundant brakes only).
  status outcome = status::ok;
  /// Metres into the wall for each metre along it [1], >= 0. Infinite where the hand is not held at any
  /// slope, and where there is no result.
  T slope = std::numeric_limits<T>::infinity();
};

namespace detail {

// Rates of rounding size, beside the greatest of a vector, are none.
template <class T, int Brakes>
vector<T, Brakes> without_rounding(const vector<T, Brakes>& w) {
  const T rounding = rounding_tolerance<T>(Brakes) * w.cwiseAbs().maxCoeff();
  return (w.array().abs() > rounding).select(w, T(0));
}

}  // namespace detail

/// Least slope >= 0 at which brakes resist `push` [N] whose forces add up: those of n = d, and of redundant
/// brakes. a and b (m): rates of the brakes for a unit velocity along the wall and out of
/// it, so that brake i turns at a_i - slope b_i. at_rest: the torques that each can make at rest [N m].
/// motor_limit: what it can make however it turns [N m], from a motor beside it, or 0.
///
/// From slope_i = max(0, a_i / b_i) on, brake i turns so that it pushes out of the wall, with |b_i| times its
/// torque. So the strongest normal force is a staircase in the slope, and the least slope is a weighted
/// quantile:
///
///     min { slope_i : sum over slope_k <= slope_i of |b_k| L_k  +  sum over the others of |b_k| motor_k >= P
///     }
///
/// with L_k the bound of brake k that way; infinite where all together are too weak. Cost: m^2 additions.
template <class T, int Brakes>
T min_sink_slope(const vector<T, Brakes>& a, const vector<T, Brakes>& b, const torque_box<T, Brakes>& at_rest,
                 const vector<T, Brakes>& motor_limit, T push) {
  const vector<T, Brakes> along = detail::without_rounding(a), out = detail::without_rounding(b);
  // The slope at which each brake turns round, and its force before and after
  vector<T, Brakes> slope = vector<T, Brakes>::Zero(), before = slope, after = slope;
  for (int i = 0; i < Brakes; ++i) {
    if (out[i] == T(0)) continue;
    slope[i] = std::max(along[i] / out[i], T(0));
    before[i] = std::abs(out[i]) * motor_limit[i];
    after[i] = out[i] * (out[i] > T(0) ? at_rest.upper[i] : at_rest.lower[i]);
  }
  T least = std::numeric_limits<T>::infinity();
  const auto consider = [&](T at) {
    T force = T(0);
    for (int k = 0; k < Brakes; ++k) force += slope[k] <= at ? after[k] : before[k];
    if (force >= push && at < least) least = at;
  };
  consider(T(0));
  for (int i = 0; i < Brakes; ++i) consider(slope[i]);
  return least;
}

namespace detail {

// Of brakes whose forces do not add up: that of the whole box at each slope at which a brake turns round.
template <class M, class Motions>
typename M::scalar sink_slope_by_trial(const Motions& motions, const task_vector<M>& along,
                                       const task_vector<M>& n, const hybrid_brakes<M>& brakes,
                                       typename M::scalar push) {
  using T = typename M::scalar;
  constexpr int m = M::brake_count;
  T least = std::numeric_limits<T>::infinity();
  motions.for_each([&](const auto& W) {
    const T rounding = rounding_tolerance<T>(M::dof + m) * W.norm();
    const auto rates_for = [&](const task_vector<M>& v) -> brake_vector<M> {
      const brake_vector<M> w = W * v;
      return (w.array().abs() > rounding).select(w, T(0));
    };
    const brake_vector<M> a = rates_for(along), b = rates_for(n);
    const auto consider = [&](T slope, int turning) {
      if (!(slope < least)) return;
      brake_vector<M> signs;
      for (int i = 0; i < m; ++i) {
        const T w = a[i] - slope * b[i], terms = std::abs(a[i]) + slope * std::abs(b[i]);
        signs[i] = i != turning && std::abs(w) > rounding_tolerance<T>(m) * terms ? sgn(w) : T(0);
      }
      if (max_force_of_box(motions, passive_haptics::torque_box_of(signs, brakes), n) >= push) least = slope;
    };
    consider(T(0), m);
    for (int i = 0; i < m; ++i)
      if (a[i] * b[i] > T(0)) consider(a[i] / b[i], i);
  });
  return least;
}

}  // namespace detail

/// The sink slope: the least slope, metres into the wall for each metre along it, at which these brakes
/// resist `push` [N] against a wall with this normal, while a hand leads the end effector along it at joint
/// positions q. 0 where they hold the hand on the wall. No law lets it sink less. Direction and normal: base
/// frame, any length; of the direction the part along the wall counts. A hand that does not move along the
/// wall is held, slope 0, or it is not, infinite.
///
/// A hand that sinks at slope s moves along t - s n, t the direction and n out of the wall. Brake i then
/// turns at a_i - s b_i, with a = W t and b = W n (W = T J^+ and so on, see displayable), and from s = a_i /
/// b_i on it pushes out of the wall. Where the brakes' forces add up (n = d, redundant brakes) the least
/// slope is a weighted quantile of these (min_sink_slope). Else (n > d, singular poses) `max_force` of
/// displayable is found at each of them, for each set of brakes that can come to rest.
///
/// **No slope between them is less.** At s = a_i / b_i brake i rests and can hold either way, so that torques
/// that are possible at slopes directly below or above it are possible there: the least slope is 0 or one of
/// these.
///
/// **At steeper slopes the brakes hold, too**, if their forces add up or their self-motion settles. Let t* be
/// torques at slope s, and w the rates of the easiest way into the wall (displayable), t*_i w_i >= 0, since
/// t* makes most of a box that contains 0. At a steeper slope s + r the brakes can turn r w slower than at s,
/// so that t* still takes power from none of them. At singular poses this need not be so.
///
/// Motors of hybrid_brakes make motor_limit_i at any slope. Never allocates. Cost: some five times that of G
/// for two brakes, of which min_sink_slope is an eighth; with self-motion up to C(m, n - d)^2 (m + 1) sums
/// of m terms.
template <class M>
sink_slope_result<typename M::scalar> sink_slope(const M& mechanism, const joint_vector<M>& q,
                                                 const task_vector<M>& direction,
                                                 const task_vector<M>& normal, const hybrid_brakes<M>& brakes,
                                                 typename M::scalar push) {
  static_assert(is_mechanism<M, explain>());
  using T = typename M::scalar;
  sink_slope_result<T> found;
  found.outcome = detail::outcome_of<M>(q, direction, normal, brakes);
  if (found.outcome == status::ok && std::isnan(push)) found.outcome = status::parameters_invalid;
  if (found.outcome != status::ok) return found;
  const task_vector<M> n = direction_of(normal), along = detail::along_wall(direction, n);
  const auto of_sum = [&](const brake_matrix<M>& G) {
    const brake_vector<M> a = transposed_times(G, along), b = transposed_times(G, n),
                          rest = brake_vector<M>::Zero();
    return min_sink_slope(a, b, passive_haptics::torque_box_of(rest, brakes), brakes.motor_limit, push);
  };
  const mechanism_pose<M> pose(mechanism, q);
  if constexpr (M::dof == M::task_dimension) {
    const brake_matrix<M> G = passive_haptics::force_generators(pose);
    if (detail::forces_add_up(pose, G)) {
      found.slope = of_sum(G);
      return found;
    }
  }
  const brake_matrix<M> E(passive_haptics::brake_jacobian(mechanism, q));
  if (!all_finite(E)) {
    found.outcome = status::pose_undefined;
    return found;
  }
  const auto motions = form_of<M>::motions(mechanism, q, E, brakes);
  found.outcome = motions.outcome();
  if (found.outcome != status::ok) return found;
  found.slope = detail::sink_slope_by_trial<M>(motions, along, n, brakes, push);
  return found;
}

/// The sink slope of brakes of these torque limits [N m].
template <class M>
sink_slope_result<typename M::scalar> sink_slope(const M& mechanism, const joint_vector<M>& q,
                                                 const task_vector<M>& direction,
                                                 const task_vector<M>& normal,
                                                 const brake_vector<M>& torque_limit,
                                                 typename M::scalar push) {
  return passive_haptics::sink_slope(mechanism, q, direction, normal,
                                     hybrid_brakes<M>::with_limits(torque_limit), push);
}

}  // namespace passive_haptics
