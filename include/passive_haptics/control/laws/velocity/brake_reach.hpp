/// @file
/// What each brake can do for walls, a moment from now.
#pragma once

#include <passive_haptics/brake/signs.hpp>
#include <passive_haptics/control/control_law.hpp>
#include <passive_haptics/control/laws/velocity/acceleration_display.hpp>
#include <passive_haptics/control/laws/velocity/brake_lag.hpp>

#include <algorithm>
#include <cmath>

namespace passive_haptics {

/// What each brake can make a horizon from now: its sign times a magnitude from least to most.
template <class T, int Brakes>
struct brake_reach {
  using flags = vector<bool, Brakes>;  ///< One for each brake.

  vector<T, Brakes> sign;                  ///< Of its torque: -1 or 1.
  vector<T, Brakes> share;                 ///< Of the way to a command that the horizon covers [1].
  vector<T, Brakes> least;                 ///< What its lag leaves it at least [N m].
  vector<T, Brakes> most;                  ///< [N m], >= least.
  matrix<T, Brakes, Brakes> A;             ///< T M^-1 T^T, where any is at rest [rad/s^2 per N m].
  bool any_at_rest = false;                ///< Some brake is at rest.
  flags at_rest = flags::Constant(false);  ///< It is at rest.
  flags lasts;  ///< It can push so as long as the handle slides, not only while it lands.
};

/// T M^-1 T^T, how brake torques accelerate the brakes [rad/s^2 per N m].
template <class M>
using brake_inertia = matrix<typename M::scalar, M::brake_count, M::brake_count>;

/// Torques [N m] that would hold the brakes, the others making t: by Gauss-Seidel, those at rest at most what
/// they make now. Leaves A = T M^-1 T^T. Cost: a solution with M and some products of m x m.
template <class M>
brake_vector<M> holding_torques(const pose_dynamics<M>& device, const task_vector<M>& Fh,
                                const vector<bool, M::brake_count>& at_rest, brake_vector<M> t,
                                const brake_vector<M>& strength, brake_inertia<M>& A) {
  using T = typename M::scalar;
  constexpr int m = M::brake_count, sweeps = 3;
  const matrix<T, M::dof, m> per_torque = device.mass.solve(device.Tt);
  A = device.Tt.transpose() * per_torque;  // rad/s^2 for each N m
  const joint_vector<M> drive = device.J.transpose() * Fh - device.bias;
  const brake_vector<M> free = per_torque.transpose() * drive;
  brake_vector<M> holding = brake_vector<M>::Zero();
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (int i = 0; i < m; ++i) {
      holding[i] = t[i] - (free[i] + A.row(i).dot(t)) / A(i, i);
      if (at_rest[i]) t[i] = std::clamp(holding[i], -strength[i], strength[i]);
    }
  }
  return holding;
}

/// The reach of all brakes. w: their rates once the handle keeps its depth; they tell the signs, as rates now
/// may be those of a landing. A brake at rest is counted for at most twice what holds it, and for nothing
/// where it would hold the other way.
///
/// g: of the wall where there is one alone; a brake whose rate now pushes the handle out of it is taken so
/// even if that will not last. Null for several walls, where the rates now tell the signs of brakes that
/// turn.
template <class M, class Now>
brake_reach<typename M::scalar, M::brake_count> reach_of_brakes(
    const Now& now, const pose_dynamics<M>& device, const brake_vector<M>& w, const brake_vector<M>* g,
    const brake_lag_model& model, double horizon) {
  using T = typename M::scalar;
  constexpr int m = M::brake_count;
  constexpr T most_held(2);  // of what holds a brake at rest, by a sensor and inertia that are off
  brake_reach<T, m> reach;
  brake_vector<M> strength, made;
  unrolled<m>([&](auto i) {
    const T band = rate_dead_band_of<T>(now.brakes, i);
    reach.at_rest[i] = !slips(device.rates[i], band);
    reach.any_at_rest = reach.any_at_rest || reach.at_rest[i] || !slips(w[i], band);
    strength[i] = static_cast<T>(model.torque(i));
    made[i] = reach.at_rest[i] ? T(0) : -std::copysign(strength[i], device.rates[i]);
  });
  brake_vector<M> holding = brake_vector<M>::Zero();
  if (reach.any_at_rest)
    holding =
        passive_haptics::holding_torques(device, now.hand_force, reach.at_rest, made, strength, reach.A);
  unrolled<m>([&](auto i) {
    const T band = rate_dead_band_of<T>(now.brakes, i);
    const bool turns = g == nullptr && !reach.at_rest[i];
    const T rate = turns ? device.rates[i] : (slips(w[i], band) ? w[i] : -holding[i]);
    reach.sign[i] = rate > T(0) ? T(-1) : T(1);
    reach.lasts[i] = true;
    if (g != nullptr && reach.sign[i] * (*g)[i] <= T(0) && device.rates[i] * (*g)[i] < T(0)) {
      reach.sign[i] = -reach.sign[i];
      reach.lasts[i] = false;
    }
    const T lag = now.brakes.time_constant[i];
    reach.share[i] = horizon > 0 ? lag_share(static_cast<T>(horizon), lag) : T(1);
    reach.least[i] = strength[i] * (T(1) - reach.share[i]);
    reach.most[i] = passive_haptics::torque_limit_of<T>(now.brakes, i);
    if (reach.at_rest[i])
      reach.most[i] = holding[i] * reach.sign[i] > T(0)
                          ? std::min(reach.most[i], most_held * std::abs(holding[i]))
                          : T(0);
    reach.most[i] = std::max(reach.least[i], reach.most[i]);
  });
  return reach;
}

}  // namespace passive_haptics
