/// Slope at which a hand sinks into a wall that brakes cannot display.
#pragma once

#include <passive_haptics/design/max_resistance.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace passive_haptics {

/// Result of sink_slope.
template <class T>
struct sink_slope_result {
  /// ok, also if nothing holds the hand; else state_not_finite, contact_invalid (no normal),
  /// parameters_invalid (a limit, or a NaN push), pose_undefined, singular_jacobian (redundant brakes only).
  status outcome = status::ok;
  /// Depth per distance along the wall [1], >= 0; infinite if the hand is not held at any slope.
  T slope = std::numeric_limits<T>::infinity();
};

namespace detail {

// Sets rates of rounding size to 0.
template <class T, int Brakes>
vector<T, Brakes> without_rounding(const vector<T, Brakes>& w) {
  const T rounding = rounding_tolerance<T>(Brakes) * w.cwiseAbs().maxCoeff();
  return (w.array().abs() > rounding).select(w, T(0));
}

}  // namespace detail

/// Returns the minimum slope >= 0 at which brakes resist `push` [N] if their forces add up (n = d, and
/// redundant brakes). a and b (m): brake rates for a unit velocity along the wall and along its outward
/// normal, so that brake i rotates at a_i - slope b_i. at_rest: torques of each brake at rest [N m].
/// motor_limit: torques of motors in any motion [N m].
///
/// From slope_i = max(0, a_i / b_i) on, brake i pushes out of the wall with |b_i| times its torque. The
/// maximum normal force is a step function of the slope, and the minimum slope is a weighted quantile:
///
///     min { slope_i : sum over slope_k <= slope_i of |b_k| L_k + sum over the others of |b_k| motor_k >= P }
///
/// with the bound L_k of brake k in that direction; infinite if all together are too weak.
template <class T, int Brakes>
T min_sink_slope(const vector<T, Brakes>& a, const vector<T, Brakes>& b, const torque_box<T, Brakes>& at_rest,
                 const vector<T, Brakes>& motor_limit, T push) {
  const vector<T, Brakes> along = detail::without_rounding(a), out = detail::without_rounding(b);
  // Slope at which each brake reverses, and its force before and after
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

// For brakes with forces that do not add up: tries each slope at which a brake reverses.
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

/// Returns the sink slope: the minimum slope, depth per distance along the wall, at which these brakes resist
/// `push` [N] while a hand moves the end effector along a wall with this normal at joint positions q. 0 if
/// they hold the hand on the wall. No law achieves less. Direction and normal: base frame, any length; only
/// the direction's part along the wall counts. For a hand that does not move along the wall the slope is 0 if
/// it is held, else infinite.
///
/// A hand that sinks at slope s moves along t - s n, with the direction t and the outward normal n. Brake i
/// then rotates at a_i - s b_i, a = W t and b = W n (W = T J^+ and so on, see displayable), and pushes out of
/// the wall from s = a_i / b_i on. If forces add up (n = d, redundant brakes), the minimum slope is a
/// weighted quantile of these (min_sink_slope). Otherwise (n > d, singular poses) `max_force` of displayable
/// is evaluated at each of them, for each set of brakes that can come to rest.
///
/// **The minimum is 0 or one of these slopes.** At s = a_i / b_i brake i rests and can hold either way, so
/// torques that are possible at slopes directly below or above are possible there.
///
/// **The brakes also hold at steeper slopes**, if their forces add up or their self-motion settles. Let t* be
/// torques at slope s, and w the rates of the easiest motion into the wall (displayable), t*_i w_i >= 0,
/// since t* is optimal in a box that contains 0. At a steeper slope s + r the brakes can rotate r w slower
/// than at s, so t* still does not drive any of them. This need not hold at singular poses.
///
/// Motors of hybrid_brakes produce motor_limit_i at any slope. Never allocates. With self-motion up to C(m, n
/// - d)^2 (m + 1) sums of m terms.
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

/// Overload for brakes with these torque limits [N m].
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
