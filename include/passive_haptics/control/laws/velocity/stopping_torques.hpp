/// @file
/// Brake torques that stop a handle where several walls together leave it no way to go.
#pragma once

#include <passive_haptics/brake/signs.hpp>
#include <passive_haptics/brake/torque_interval.hpp>
#include <passive_haptics/control/laws/velocity/acceleration_display.hpp>
#include <passive_haptics/core/linear/cone.hpp>
#include <passive_haptics/core/linear/least_squares_by_priority.hpp>
#include <passive_haptics/core/linear/orthogonal_decomposition.hpp>
#include <passive_haptics/core/linear/space_cone.hpp>
#include <passive_haptics/force/torques/torque_units.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace passive_haptics {

/// A motion of device and hand in coordinates y = M^1/2 qd, whose square is twice the kinetic energy.
template <class M>
struct weighted_motion {
  joint_vector<M> now;   ///< M^1/2 qd [J^1/2]
  joint_vector<M> push;  ///< M^-1/2 (J^T Fh - c), what hand and gravity add to it each second [J^1/2 / s].

  /// With the hand doing Fh [N]. Cost: one solution with half of M.
  weighted_motion(const pose_dynamics<M>& dynamics, const task_vector<M>& Fh)
      : now(dynamics.mass.half_product(dynamics.qd)),
        push(dynamics.mass.half_solve(joint_vector<M>(transposed_times(dynamics.J, Fh) - dynamics.bias))) {}
};

/// True if the walls that may not be entered, two or more, leave no more than a tenth of the motion that the
/// free handle would have `ahead` seconds from now. Walls without friction take from it what points into
/// them (Gauss's principle): y* is nearest to y under n_j . J M^-1/2 y* >= 0, a projection onto a cone.
template <class M, class Wall, std::size_t Capacity, class T = typename M::scalar>
bool is_cornered(const pose_dynamics<M>& dynamics, const weighted_motion<M>& motion,
                 const std::array<Wall, Capacity>& walls, int count, T ahead) {
  constexpr int n = M::dof, capacity = static_cast<int>(Capacity);
  constexpr T most_left(0.1);
  matrix<T, n, capacity> into = matrix<T, n, capacity>::Zero();
  int closed = 0;
  for (int j = 0; j < count; ++j) {
    const Wall& wall = walls[std::size_t(j)];
    if (!wall.is_closed()) continue;
    ++closed;
    into.col(j) = -dynamics.mass.half_solve(joint_vector<M>(transposed_times(dynamics.J, wall.along.normal)));
  }
  if (closed < 2) return false;
  joint_vector<M> y = motion.now + ahead * motion.push, left = project_onto_half_spaces(into, y).point;
  if constexpr (n > M::task_dimension) {  // nobody asks where the self-motion goes
    const orthogonal_decomposition<T, M::task_dimension, n> handle(
        matrix<T, M::task_dimension, n>(
            transposed(dynamics.mass.half_solve(matrix<T, n, M::task_dimension>(transposed(dynamics.J))))),
        rounding_tolerance<T>(n));
    y -= handle.without_row_space(y);
    left -= handle.without_row_space(left);
  }
  return left.norm() <= most_left * y.norm();
}

/// Magnitudes [N m] of the brake torques that stop device and hand in a time [s] and hold more than hand and
/// gravity do, as sensor and inertia may be off: what a brake at rest does not need it does not make. The
/// least |M^-1/2 (T^T t + held (J^T Fh - c)) + M^1/2 qd / time| within the limits and the signs of brakes
/// that turn, of these the least |t / u|. Cost: two levels of core/linear/least_squares_by_priority.hpp.
template <class M, class Brakes, class T = typename M::scalar>
brake_vector<M> stopping_torques(const pose_dynamics<M>& dynamics, const weighted_motion<M>& motion,
                                 const Brakes& brakes, T time) {
  constexpr int n = M::dof, m = M::brake_count;
  constexpr T held(1.4);
  brake_vector<M> lower, upper;
  for (int i = 0; i < m; ++i) {
    const T w = dynamics.rates[i];
    const bool turns = slips(w, rate_dead_band_of<T>(brakes, i));
    lower[i] = turns && w < T(0) ? T(0) : -torque_bound_of<T>(brakes, i, T(-1));
    upper[i] = turns && w > T(0) ? T(0) : torque_bound_of<T>(brakes, i, T(1));
  }
  const matrix<T, n, m> per_torque = dynamics.mass.half_solve(dynamics.Tt);
  const joint_vector<M> wanted = -held * motion.push - motion.now / time;
  const auto u = passive_haptics::torque_units_of<M>(brake_vector<M>(brake_vector<M>::Zero()), brakes);
  const matrix<T, m, m> parts = passive_haptics::parts_per_torque<T, m>(u).asDiagonal();
  return least_squares_by_priority(lower, upper, least_squares_level{per_torque, wanted},
                                   least_squares_level{parts})
      .cwiseAbs();
}

}  // namespace passive_haptics
