/// Torque ranges of the brakes after the horizon.
#pragma once

#include <passive_haptics/brake/signs.hpp>
#include <passive_haptics/brake/torque_interval.hpp>
#include <passive_haptics/control/control_law.hpp>
#include <passive_haptics/control/laws/velocity/acceleration_display.hpp>
#include <passive_haptics/control/laws/velocity/brake_lag.hpp>

#include <algorithm>
#include <cmath>

namespace passive_haptics {

/// Torques that each brake can have after a horizon: its sign times a magnitude in [lower, upper].
template <class T, int Brakes>
struct torque_range {
  using flags = vector<bool, Brakes>;  ///< One per brake.

  vector<T, Brakes> sign;                  ///< Sign of the torque: -1 or 1.
  vector<T, Brakes> lag_share;             ///< Share of the step to a command within the horizon [1].
  vector<T, Brakes> lower;                 ///< Minimum because of the lag [N m].
  vector<T, Brakes> upper;                 ///< [N m], >= lower.
  matrix<T, Brakes, Brakes> A;             ///< T M^-1 T^T, if any brake is at rest [rad/s^2 per N m].
  bool any_at_rest = false;                ///< Some brake is at rest.
  flags at_rest = flags::Constant(false);  ///< The brake is at rest.
  flags held = flags::Constant(false);     ///< The limit allows twice the holding torque.
  /// Current torque of a brake at rest, if releasing it may let the handle in; else 0 [N m].
  vector<T, Brakes> kept;
  flags sign_is_lasting;  ///< The sign holds while the handle slides, not only while it lands.
};

/// T M^-1 T^T, from brake torques to brake accelerations [rad/s^2 per N m].
template <class M>
using brake_inertia = matrix<typename M::scalar, M::brake_count, M::brake_count>;

/// Torques [N m] that would hold the brakes while the others have torques t, by Gauss-Seidel, with brakes at
/// rest limited to their strength. Sets A = T M^-1 T^T. Cost: a solution with M and m x m products.
template <class M>
brake_vector<M> holding_torques(const pose_dynamics<M>& dynamics, const task_vector<M>& Fh,
                                const vector<bool, M::brake_count>& at_rest, brake_vector<M> t,
                                const brake_vector<M>& strength, brake_inertia<M>& A) {
  using T = typename M::scalar;
  constexpr int m = M::brake_count, sweeps = 3;
  const matrix<T, M::dof, m> per_torque = dynamics.mass.solve(dynamics.Tt);
  A = transposed_times(dynamics.Tt, per_torque);  // [rad/s^2 per N m]
  const joint_vector<M> drive = transposed_times(dynamics.J, Fh) - dynamics.bias;
  const brake_vector<M> free = per_torque.transpose() * drive;
  brake_vector<M> holding = brake_vector<M>::Zero();
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (int i = 0; i < m; ++i) {
      holding[i] = t[i] - (free[i] + row_of(A, i).dot(t)) / A(i, i);
      if (at_rest[i]) t[i] = std::clamp(holding[i], -strength[i], strength[i]);
    }
  }
  return holding;
}

/// Torque [N m] of brake i with a strength from the lag of its commands, in the direction of `torque` or in
/// both. 0 if the brake is off, regardless of its lag. The strength itself for brakes without an interval.
template <class T, class B>
T within_interval(T strength, [[maybe_unused]] const B& brakes, [[maybe_unused]] int i,
                  [[maybe_unused]] bool either_way, [[maybe_unused]] T torque) {
  if constexpr (detail::names_torque_interval<B>) {
    const T bound = passive_haptics::torque_bound_of<T>(brakes, i, torque);
    return std::min(strength, either_way
                                  ? std::max(bound, passive_haptics::torque_bound_of<T>(brakes, i, -torque))
                                  : bound);
  } else {
    return strength;
  }
}

/// Ranges of all brakes for one wall with response g. w: rates once the handle keeps its depth. Signs are
/// those of w, because the current rates may be those of a landing, except for brakes that now push the
/// handle out. A brake at rest has at most twice its holding torque, 0 if that has the wrong sign.
template <class M, class Device>
torque_range<typename M::scalar, M::brake_count> torque_ranges_of(
    const Device& device, const pose_dynamics<M>& dynamics, const brake_vector<M>& w,
    const brake_vector<M>& g, const brake_lag_model& model, double horizon) {
  using T = typename M::scalar;
  constexpr int m = M::brake_count;
  constexpr T max_held(2);  // of the holding torque, as a margin for errors of sensor and inertia
  torque_range<T, m> range;
  range.lag_share = passive_haptics::lag_shares(device.brakes, horizon);
  brake_vector<M> strength, made;
  unrolled<m>([&](auto i) {
    const T band = rate_dead_band_of<T>(device.brakes, i);
    range.at_rest[i] = !slips(dynamics.rates[i], band);
    range.any_at_rest = range.any_at_rest || range.at_rest[i] || !slips(w[i], band);
    strength[i] = within_interval(static_cast<T>(model.torque(i)), device.brakes, i, range.at_rest[i],
                                  -dynamics.rates[i]);
    made[i] = range.at_rest[i] ? T(0) : -std::copysign(strength[i], dynamics.rates[i]);
  });
  brake_vector<M> holding = brake_vector<M>::Zero();
  if (range.any_at_rest)
    holding =
        passive_haptics::holding_torques(dynamics, device.hand_force, range.at_rest, made, strength, range.A);
  unrolled<m>([&](auto i) {
    const T rate = slips(w[i], rate_dead_band_of<T>(device.brakes, i)) ? w[i] : -holding[i];
    range.sign[i] = rate > T(0) ? T(-1) : T(1);
    range.sign_is_lasting[i] = !(range.sign[i] * g[i] <= T(0) && dynamics.rates[i] * g[i] < T(0));
    if (!range.sign_is_lasting[i]) range.sign[i] = -range.sign[i];
    range.lower[i] =
        within_interval(strength[i], device.brakes, i, false, range.sign[i]) * (T(1) - range.lag_share[i]);
    range.upper[i] = passive_haptics::torque_bound_of<T>(device.brakes, i, range.sign[i]);
    range.kept[i] = T(0);
    if (range.at_rest[i]) {
      const T enough = std::max(max_held * holding[i] * range.sign[i], T(0));
      range.held[i] = enough > T(0) && enough <= range.upper[i];
      if (enough > T(0)) range.kept[i] = strength[i];
      range.upper[i] = std::min(range.upper[i], enough);
    }
    range.upper[i] = std::max(range.lower[i], range.upper[i]);
  });
  return range;
}

/// For several walls: current rates determine the signs of rotating brakes.
template <class M, class Device>
torque_range<typename M::scalar, M::brake_count> torque_ranges_of(const Device& device,
                                                                  const pose_dynamics<M>& dynamics,
                                                                  const brake_lag_model& model,
                                                                  double horizon) {
  const brake_vector<M> no_landing = brake_vector<M>::Zero();
  return passive_haptics::torque_ranges_of(device, dynamics, dynamics.rates, no_landing, model, horizon);
}

}  // namespace passive_haptics
