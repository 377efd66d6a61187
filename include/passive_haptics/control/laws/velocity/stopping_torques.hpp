/// Brake torques that stop a handle enclosed by several walls.
#pragma once

#include <passive_haptics/brake/signs.hpp>
#include <passive_haptics/brake/torque_interval.hpp>
#include <passive_haptics/control/laws/velocity/acceleration_display.hpp>
#include <passive_haptics/control/laws/velocity/torque_range.hpp>
#include <passive_haptics/core/linear/cone.hpp>
#include <passive_haptics/core/linear/least_squares_by_priority.hpp>
#include <passive_haptics/core/linear/orthogonal_decomposition.hpp>
#include <passive_haptics/core/nth.hpp>
#include <passive_haptics/force/forms/form_of.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace passive_haptics {

/// A motion of device and hand in coordinates y = M^1/2 qd: y^T y is twice the kinetic energy.
template <class M>
struct weighted_motion {
  joint_vector<M> now;   ///< M^1/2 qd [J^1/2]
  joint_vector<M> push;  ///< M^-1/2 (J^T Fh - c), its rate of change by hand and gravity [J^1/2 / s].

  /// At joint rates qd and hand force Fh [N]. Cost: one solution with half of M.
  weighted_motion(const pose_dynamics<M>& dynamics, const joint_vector<M>& qd, const task_vector<M>& Fh)
      : now(dynamics.mass.half_product(qd)),
        push(dynamics.mass.half_solve(joint_vector<M>(transposed_times(dynamics.J, Fh) - dynamics.bias))) {}
};

/// True if two or more closed walls leave at most a tenth of the motion that the free handle would have
/// `ahead` seconds from now. Frictionless walls remove the components into them (Gauss's principle): y* is
/// nearest to y under n_j . J M^-1/2 y* >= 0, a projection onto a cone.
template <class M, class Wall, std::size_t Capacity, class T = typename M::scalar>
bool is_cornered(const pose_dynamics<M>& dynamics, const weighted_motion<M>& motion,
                 const std::array<Wall, Capacity>& walls, int count, T ahead) {
  constexpr int n = M::dof, capacity = static_cast<int>(Capacity);
  constexpr T max_left = T(0.1);
  matrix<T, n, capacity> into = matrix<T, n, capacity>::Zero();
  int closed = 0;
  for (int j = 0; j < count; ++j) {
    const Wall& wall = nth(walls, j);
    if (!wall.is_closed()) continue;
    ++closed;
    into.col(j) = -dynamics.mass.half_solve(joint_vector<M>(transposed_times(dynamics.J, wall.along.normal)));
  }
  if (closed < 2) return false;
  joint_vector<M> y = motion.now + ahead * motion.push, left = project_onto_half_spaces(into, y).point;
  if constexpr (n > M::task_dimension) {  // excludes the self-motion
    const orthogonal_decomposition<T, M::task_dimension, n> handle(
        matrix<T, M::task_dimension, n>(
            transposed(dynamics.mass.half_solve(matrix<T, n, M::task_dimension>(transposed(dynamics.J))))),
        rounding_tolerance<T>(n));
    y -= handle.without_row_space(y);
    left -= handle.without_row_space(left);
  }
  return left.norm() <= max_left * y.norm();
}

/// True if the handle enters all of two or more closed walls, one with less than half of its demand from t.
template <class Wall, std::size_t Capacity, class T, int Brakes>
bool enters_undisplayed(const std::array<Wall, Capacity>& walls, int count,
                        const torque_range<T, Brakes>& brakes, const vector<T, Brakes>& t) {
  if (brakes.at_rest.all()) return false;
  const vector<T, Brakes> torque = brakes.sign.cwiseProduct(t);
  int closed = 0;
  bool misses = false;
  for (int j = 0; j < count; ++j) {
    const Wall& wall = nth(walls, j);
    if (!wall.is_closed()) continue;
    if (!(wall.stop_speed > T(0))) return false;
    ++closed;
    misses = misses || wall.along.inertia * wall.along.g.dot(torque) < T(0.5) * wall.force;
  }
  return closed > 1 && misses;
}

/// Magnitudes [N m] of the brake torques that stop device and hand in a time [s] and hold more than hand and
/// gravity require, as a margin for errors of sensor and inertia. Minimises |M^-1/2 (T^T t + held (J^T Fh -
/// c)) + M^1/2 qd / time| within the limits and signs of rotating brakes, then |t / u|. If a brake at rest is
/// at its limit, the others at rest get at least their torques without these limits. Cost: two levels of
/// core/linear/least_squares_by_priority.hpp, twice if a brake at rest is at its limit.
template <class M, class Brakes, class T = typename M::scalar>
brake_vector<M> stopping_torques(const pose_dynamics<M>& dynamics, const weighted_motion<M>& motion,
                                 const Brakes& brakes, T time) {
  constexpr int n = M::dof, m = M::brake_count;
  constexpr T held = T(1.3);
  brake_vector<M> lower, upper, unlimited;  // the last for brakes at rest
  for (int i = 0; i < m; ++i) {
    const T w = dynamics.rates[i];
    const bool turns = slips(w, rate_dead_band_of<T>(brakes, i));
    lower[i] = turns && w < T(0) ? T(0) : -torque_bound_of<T>(brakes, i, T(-1));
    upper[i] = turns && w > T(0) ? T(0) : torque_bound_of<T>(brakes, i, T(1));
    unlimited[i] = turns ? T(0) : std::numeric_limits<T>::infinity();
  }
  const matrix<T, n, m> per_torque = dynamics.mass.half_solve(dynamics.Tt);
  const joint_vector<M> wanted = -held * motion.push - motion.now / time;
  const auto u = form_of<M>::units(brake_vector<M>(brake_vector<M>::Zero()), brakes);
  const matrix<T, m, m> parts = passive_haptics::parts_per_torque<T, m>(u).asDiagonal();
  const auto within = [&](const brake_vector<M>& low, const brake_vector<M>& high) -> brake_vector<M> {
    return least_squares_by_priority(low, high, least_squares_level{per_torque, wanted},
                                     least_squares_level{parts});
  };
  const brake_vector<M> t = within(lower, upper);
  bool is_short = false;
  for (int i = 0; i < m; ++i)
    is_short = is_short || (unlimited[i] > T(0) && !(lower[i] < t[i] && t[i] < upper[i]));
  if (!is_short) return t.cwiseAbs();
  const brake_vector<M> strong = within(lower - unlimited, upper + unlimited).cwiseMax(lower).cwiseMin(upper);
  return t.cwiseAbs().cwiseMax(strong.cwiseAbs());
}

}  // namespace passive_haptics
