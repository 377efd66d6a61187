/// Hand torques on brakes at rest, for a known inertia of the mechanism.
///
/// Let S be the brakes at rest and D the slipping ones. With M qdd + c = J^T Fh + T^T t and w = T qd, the
/// brakes S stay at rest, wd_S = 0, under the torques
///
///     t_S = -A_SS^-1 [ T_S M^-1 (J^T Fh - c + T_D^T t_D) + Td_S qd ],   A = T M^-1 T^T,
///
/// and th_S = -t_S is the torque of the hand, gravity and the other brakes on them. For one brake at rest, th
/// has the sign of the acceleration that the brake would have without torque.
#pragma once

#include <passive_haptics/brake/at_rest/brake_bias_acceleration.hpp>
#include <passive_haptics/brake/signs.hpp>
#include <passive_haptics/core/linear/cholesky.hpp>
#include <passive_haptics/core/linear/orthogonal_decomposition.hpp>
#include <passive_haptics/core/matrix.hpp>
#include <passive_haptics/mechanism/dynamics.hpp>

#include <cmath>

namespace passive_haptics {

/// Torques th (m) [N m or N] on the brakes at rest, 0 for the others, for any numbers of brakes m and joints
/// n. mass: M (n x n); Tt: T^T (n x m); drive: J^T Fh - c + T_D^T t_D (n) [N m or N]; drift: Td qd (m)
/// [rad/s^2 or m/s^2]; at_rest: one flag per brake. If A_SS is singular, as with more brakes at rest than
/// joints, the result is the least-norm solution of least acceleration; 0 if M is not positive definite.
/// Decomposes M = L L^T (n x n) and W = L^-1 T_S^T (n x m), as A_SS = W^T W.
template <class T, int Joints, int Brakes>
vector<T, Brakes> hand_torque_at_rest(const matrix<T, Joints, Joints>& mass,
                                      const matrix<T, Joints, Brakes>& Tt, const vector<T, Joints>& drive,
                                      const vector<T, Brakes>& drift, const vector<bool, Brakes>& at_rest) {
  const cholesky<T, Joints> inertia(mass);
  if (!inertia.is_positive_definite()) return vector<T, Brakes>::Zero();
  matrix<T, Joints, Brakes> W = inertia.half_solve(Tt);
  vector<T, Brakes> drift_at_rest = drift;
  for (int i = 0; i < Brakes; ++i) {
    if (at_rest[i]) continue;
    W.col(i).setZero();
    drift_at_rest[i] = T(0);
  }
  // th = (W^T W)^+ (W^T L^-1 drive + drift)
  const orthogonal_decomposition<T, Joints, Brakes> at(W, rounding_tolerance<T>(Joints + Brakes));
  return at.solve(vector<T, Joints>(inertia.half_solve(drive) + at.solve_transposed(drift_at_rest)));
}

/// Torques th (m) [N m or N] on the brakes at rest, 0 for the others, for a mechanism in a pose. w: brake
/// rates [rad/s or m/s]; strength: torques of slipping brakes [N m], >= 0. Cost: as above. A control cycle
/// uses the torques_at_rest of its state if available; otherwise the static rule th = E^T Fh
/// (brake/signs.hpp).
template <Dynamics M, class B, class State>
brake_vector<M> exact_hand_torque(const mechanism_pose<M>& pose, const B& brakes, const State& state,
                                  const brake_vector<M>& w, const brake_vector<M>& strength) {
  using T = typename M::scalar;
  vector<bool, M::brake_count> at_rest;
  brake_vector<M> t;
  for (int i = 0; i < M::brake_count; ++i) {
    at_rest[i] = !slips(w[i], rate_dead_band_of<T>(brakes, i));
    t[i] = at_rest[i] ? T(0) : -std::copysign(strength[i], w[i]);
  }
  const matrix<T, M::dof, M::brake_count> Tt = pose.transposed_transmission();
  const jacobian_matrix<M> J(pose.jacobian());
  const joint_vector<M> drive = J.transpose() * state.hand_force - pose.bias_torque(state.qd) + Tt * t;
  return passive_haptics::hand_torque_at_rest(
      pose.mass_matrix(), Tt, drive,
      passive_haptics::brake_bias_acceleration(pose.mechanism(), state.q, state.qd), at_rest);
}

}  // namespace passive_haptics
