/// A random plane in a device's workspace, with a path along it.
#pragma once

#include <passive_haptics/brake/force_generators.hpp>
#include <passive_haptics/core/finite.hpp>
#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/mechanism/jacobian.hpp>
#include <passive_haptics/plant/random_numbers.hpp>

#include <Eigen/LU>

#include <algorithm>
#include <random>

namespace passive_haptics {

/// Usable workspace of a device.
template <class M>
struct workspace {
  joint_vector<M> lower;     ///< Minimum start positions [rad or m].
  joint_vector<M> upper;     ///< Maximum start positions [rad or m].
  double path_length;        ///< Length of a path along a plane [m].
  double brake_radius = 1;   ///< Force of sliding brakes at this radius is torque [m]; else 1.
  double max_condition = 8;  ///< Maximum |J| |J^-1| (Frobenius) along a path [1]; d at an isotropic pose.
  double min_cosine = 0.17;  ///< Minimum cosine between a reference force and the normal at the start [1].
};

/// A plane and a path along it.
template <class M>
struct random_plane {
  task_vector<M> surface;    ///< Point of the plane [m], under the start.
  task_vector<M> normal;     ///< Outward unit normal.
  task_vector<M> direction;  ///< Unit direction of the path.
  task_vector<M> start;      ///< Start of the handle [m], in front of the plane.
  joint_vector<M> q;         ///< Joint positions at the start [rad or m].
  joint_vector<M> qd;        ///< Joint rates at the start, along and towards the plane.
};

/// Moves joint positions q [rad or m] until the handle is at x [m], by Newton's method to 1e-9 m. Returns
/// false if x is out of reach or the condition exceeds where.max_condition.
template <class M>
bool reach(const M& mechanism, const workspace<M>& where, const task_vector<M>& x, joint_vector<M>& q) {
  using square = matrix<typename M::scalar, M::dof, M::dof>;
  for (int k = 0; k < 8; ++k) {
    const square J(passive_haptics::jacobian(mechanism, q)), inverse = J.inverse();
    if (!(J.norm() * inverse.norm() <= where.max_condition)) return false;
    const task_vector<M> off = x - mechanism.position(q);
    if (off.norm() < 1e-9) return true;
    q += inverse * off;
  }
  return false;
}

/// Maximum cosine between the normal and one brake's force for a handle velocity v; < 0 if none displays.
template <class M>
double max_cosine(const M& mechanism, const joint_vector<M>& q, const task_vector<M>& v,
                  const task_vector<M>& normal) {
  const brake_matrix<M> F = passive_haptics::force_generators(mechanism, q);
  const brake_vector<M> w = F.transpose() * v;  // F . v = t . w
  double best = -1;
  for (int i = 0; i < M::brake_count; ++i) {
    const double along = static_cast<double>(F.col(i).dot(normal) / F.col(i).norm());
    best = std::max(best, w[i] > 0 ? -along : along);
  }
  return best;
}

/// Draws start poses, directions and normals until the path is feasible and a force can be displayed at its
/// start. speed: along the plane, approach: towards it [m/s], gap: in front of it [m]. Requires as many
/// joints as task dimensions.
template <class M>
random_plane<M> draw_plane(const M& mechanism, const workspace<M>& where, double speed, double gap,
                           double approach, std::mt19937_64& bits) {
  static_assert(M::dof == M::task_dimension);
  using T = typename M::scalar;
  constexpr int d = M::task_dimension;
  const auto direction = [&] {
    task_vector<M> u;
    for (int i = 0; i < d; ++i) u[i] = static_cast<T>(normal_number(bits));
    return task_vector<M>(u.normalized());
  };
  constexpr int max_trials = 100000;
  for (int trial = 0; trial < max_trials; ++trial) {
    random_plane<M> plane;
    for (int i = 0; i < M::dof; ++i)
      plane.q[i] = where.lower[i] + (where.upper[i] - where.lower[i]) * static_cast<T>(uniform_number(bits));
    plane.normal = direction();
    const task_vector<M> u = direction();
    plane.direction = (u - plane.normal * plane.normal.dot(u)).normalized();
    plane.start = mechanism.position(plane.q);
    plane.surface = plane.start - static_cast<T>(gap) * plane.normal;
    joint_vector<M> q = plane.q;
    bool can_be_gone = all_finite(plane.start);
    constexpr int points = 20;
    for (int k = 0; k <= points && can_be_gone; ++k) {
      const task_vector<M> x =
          plane.surface + plane.direction * static_cast<T>(where.path_length * k / points);
      can_be_gone = reach(mechanism, where, x, q);
    }
    if (!can_be_gone) continue;
    if (!(max_cosine(mechanism, plane.q, plane.direction, plane.normal) >= where.min_cosine)) continue;
    const matrix<T, d, d> J(passive_haptics::jacobian(mechanism, plane.q));
    plane.qd =
        J.inverse() * (static_cast<T>(speed) * plane.direction - static_cast<T>(approach) * plane.normal);
    return plane;
  }
  require_no_error("none of the sampled planes is within reach of the arm; draw another device");
  return {};
}

}  // namespace passive_haptics
