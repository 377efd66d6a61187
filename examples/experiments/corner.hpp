// Corners of half-spaces and other obstacles near a wall, drawn randomly in a device's workspace.
#pragma once

#include "plants.hpp"

#include <passive_haptics/plant/random_plane.hpp>
#include <passive_haptics/scene/shapes/convex_polytope.hpp>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace experiments {

inline constexpr double corner_push = 2;    // of the hand, also for pulling out [N]
inline constexpr double corner_gap = 1e-3;  // between hand and wall at the start [m]

// A device and the part of its workspace for corners.
template <class M>
struct corner_device {
  std::string name;
  M mechanism;
  ph::workspace<M> where;  // path_length: of a hand to the corner
  ph::brakes_of<M> brakes = {};
  double count = 2 * std::numbers::pi / 8192;  // of the encoders [rad or m]
};

// The obstacle that the hand meets while it glides along a wall.
struct obstacle {
  enum class kind { meeting_walls, convex_edge, opposite_wall, wall_below } what = kind::meeting_walls;
  double min_angle = 60, max_angle = 150;  // of a corner or an edge [deg]
  double distance = 0;                     // of a wall that is parallel [m]
  int walls = 2;                           // of a corner
};

// The walls and the path of the hand: along walls[0] to the apex, then a push between the normals, or past
// the apex.
template <class M>
struct corner {
  static constexpr int D = M::task_dimension;
  using V = ph::vector<double, D>;
  std::vector<ph::half_space<D>> walls;           // three; unused ones are 10 m away
  std::optional<ph::convex_polytope<D, 2>> edge;  // replaces both walls
  V apex, start, direction, push;                 // [m], [m], unit, unit
  int count = 0;                                  // number of walls
  bool passes = false;                            // the hand continues along walls[0]
  ph::joint_vector<M> q;                          // at the start
  double need = 0;                                // share of the torque limits that locked brakes need [1]

  double depth(std::size_t j, const V& x) const {
    return j == 0 && edge ? -edge->distance(x) : -walls[j].distance(x);
  }
  V normal(std::size_t j, const V& x) const {
    return j == 0 && edge ? V(edge->gradient(x)) : V(walls[j].gradient(x));
  }
  // The same corner with only one wall.
  corner only(std::size_t j) const {
    corner one = *this;
    for (std::size_t i = 0; i < walls.size(); ++i)
      if (i != j) one.walls[i] = far_from(apex, normal(i, apex));
    one.edge.reset();
    return one;
  }
  static ph::half_space<D> far_from(const V& x, const V& n) { return {x - 10 * n, n}; }
};

// Minimum share of the torque limits with which locked brakes hold a force at the handle: for no virtual
// motion does the force deliver more power than the brakes dissipate. The critical motion moves as few brakes
// as possible.
template <class M>
double needed_share(const M& mechanism, const ph::brake_vector<M>& limits, const ph::joint_vector<M>& q,
                    const ph::task_vector<M>& force) {
  const ph::jacobian_matrix<M> J(ph::jacobian(mechanism, q));
  const ph::matrix<double, M::dof, M::brake_count> Tt(ph::transposed_transmission(mechanism, q));
  const ph::joint_vector<M> torque = J.transpose() * force;
  double share = 0;
  const auto move = [&](const ph::joint_vector<M>& rate) {
    const ph::brake_vector<M> w = Tt.transpose() * rate;
    share = std::max(share, std::abs(torque.dot(rate)) / limits.dot(w.cwiseAbs()));
  };
  if constexpr (M::brake_count == M::dof) {
    const ph::matrix<double, M::dof, M::dof> rates = Tt.transpose().inverse();
    for (int i = 0; i < M::dof; ++i) move(rates.col(i));
  } else {
    static_assert(M::dof == 2);
    for (int i = 0; i < M::brake_count; ++i) move({-Tt(1, i), Tt(0, i)});
  }
  return share;
}

// Moves q until the handle is at x; false if out of reach or near a singular pose. reach() for any dof.
template <class M>
bool move_to(const corner_device<M>& device, const ph::task_vector<M>& x, ph::joint_vector<M>& q) {
  constexpr int d = M::task_dimension;
  for (int k = 0; k < 20; ++k) {
    const ph::jacobian_matrix<M> J(ph::jacobian(device.mechanism, q));
    const ph::matrix<double, M::dof, d> inverse =
        J.transpose() * ph::matrix<double, d, d>(J * J.transpose()).inverse();
    if (!(J.norm() * inverse.norm() <= device.where.max_condition)) return false;
    const ph::task_vector<M> off = x - device.mechanism.position(q);
    if (off.norm() < 1e-9) return true;
    q += inverse * off;
  }
  return false;
}

// Number k of a seed: within reach up to 5 mm inside the walls, with locked brakes that hold the push with a
// tenth to spare.
template <class M>
corner<M> draw_corner(const corner_device<M>& device, const obstacle& o, std::uint64_t seed, std::size_t k) {
  constexpr int d = M::task_dimension;
  using V = ph::vector<double, d>;
  using enum obstacle::kind;
  auto bits = ph::random_bits(seed, k);
  const auto between = [&](double low, double high) { return low + (high - low) * ph::uniform_number(bits); };
  const auto any_direction = [&] {
    const V u = V::NullaryExpr([&] { return ph::normal_number(bits); });
    return V(u.normalized());
  };
  for (int trial = 0; trial < 100000; ++trial) {
    corner<M> c;
    for (int i = 0; i < M::dof; ++i) c.q[i] = between(device.where.lower[i], device.where.upper[i]);
    c.apex = device.mechanism.position(c.q);
    if (!c.apex.allFinite()) continue;
    const V n = any_direction(), u = any_direction(), side = (u - n * n.dot(u)).normalized();
    const double turn = ph::radians(180 - between(o.min_angle, o.max_angle));
    std::vector<V> normals{n};
    V away = side;  // from the apex towards the start
    c.passes = o.what != meeting_walls;
    c.direction = -side;
    if (o.what == opposite_wall || o.what == wall_below) normals.push_back(o.what == wall_below ? n : V(-n));
    else normals.push_back(std::cos(turn) * n + (o.what == convex_edge ? -1 : 1) * std::sin(turn) * side);
    if (o.what == convex_edge) c.direction = -(std::cos(turn / 2) * side + std::sin(turn / 2) * n);
    if constexpr (d == 3)
      if (o.walls == 3) {
        const V edge = n.cross(side), middle = (normals[0] + normals[1]).normalized();
        const double lean = ph::radians(between(-30, 30));
        normals.push_back(std::cos(lean) * edge + std::sin(lean) * middle);
        away = (side + edge).normalized();
        c.direction = -away;
      }
    V push = V::Zero();
    for (const V& normal : normals) push -= between(0.2, 1) * normal;
    c.push = c.passes ? V(-n) : V(push.normalized());
    c.count = static_cast<int>(normals.size());
    for (const V& normal : normals) {
      const double height = c.walls.empty() ? 0 : o.what == wall_below ? -o.distance : o.distance;
      c.walls.emplace_back(V(c.apex + height * n), normal);
    }
    if (o.what == convex_edge) c.edge.emplace(c.walls[0], c.walls[1]);
    while (c.walls.size() < 3) c.walls.push_back(c.far_from(c.apex, n));
    c.start = c.apex + device.where.path_length * away + corner_gap * n;
    c.need = needed_share<M>(device.mechanism, device.brakes.torque_limit, c.q, corner_push * c.push);
    if (!(1.1 * c.need < 1)) continue;
    ph::joint_vector<M> q = c.q;
    if (!move_to<M>(device, c.apex + 5e-3 * c.push, q)) continue;
    if (c.passes && !move_to<M>(device, c.apex + device.where.path_length * c.direction, q)) continue;
    if (!move_to<M>(device, c.start, c.q)) continue;
    return c;
  }
  throw std::logic_error("no corner of " + device.name + " can be held");
}

}  // namespace experiments
