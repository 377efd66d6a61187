// Corners of half-spaces, drawn at random in a device's workspace.
#pragma once

#include "plants.hpp"

#include <passive_haptics/plant/random_plane.hpp>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace experiments {

// A device with sensors as a real one has them, and where its corners are drawn.
template <class M>
struct corner_device {
  std::string name;
  M mechanism;
  ph::workspace<M> where;
  ph::brakes_of<M> brakes = {};
  double count = 2 * std::numbers::pi / 8192;  // of the encoders [rad or m]
};

// Walls that meet in a point or an edge, and a hand's way into them: along wall 0, then between the normals.
template <class M>
struct corner {
  static constexpr int D = M::task_dimension;
  std::vector<ph::vector<double, D>> out;   // outward normals of the walls
  ph::vector<double, D> apex, start, push;  // [m], [m], unit
  ph::joint_vector<M> q;                    // at the start
  double need = 0;                          // largest share of a torque limit that locked brakes need [1]
};

// The smallest share of the torque limits with which locked brakes hold a force at the handle: the hand moves
// nothing if no virtual rate takes more power from it than from the brakes. The worst rate leaves all joints
// but one locked.
template <class M>
double needed_share(const M& mechanism, const ph::brake_vector<M>& limits, const ph::joint_vector<M>& q,
                    const ph::task_vector<M>& force) {
  const ph::jacobian_matrix<M> J(ph::jacobian(mechanism, q));
  const ph::matrix<double, M::dof, M::brake_count> Tt(ph::transposed_transmission(mechanism, q));
  const ph::joint_vector<M> torque = J.transpose() * force;
  double share = 0;
  const auto against = [&](const ph::joint_vector<M>& rate) {
    share = std::max(share, std::abs(torque.dot(rate)) /
                                limits.dot(ph::brake_vector<M>((Tt.transpose() * rate).cwiseAbs())));
  };
  if constexpr (M::brake_count == M::dof) {
    const ph::matrix<double, M::dof, M::dof> rates = Tt.transpose().inverse();
    for (int i = 0; i < M::dof; ++i) against(rates.col(i));
  } else {
    static_assert(M::dof == 2);
    for (int i = 0; i < M::brake_count; ++i) against({-Tt(1, i), Tt(0, i)});
  }
  return share;
}

// Moves q to where the handle is at x; false out of reach or near a singular pose.
template <class M>
bool move_to(const M& mechanism, const ph::workspace<M>& where, const ph::task_vector<M>& x,
             ph::joint_vector<M>& q) {
  constexpr int d = M::task_dimension;
  for (int k = 0; k < 20; ++k) {
    const ph::jacobian_matrix<M> J(ph::jacobian(mechanism, q));
    const ph::matrix<double, M::dof, d> inverse =
        J.transpose() * ph::matrix<double, d, d>(J * J.transpose()).inverse();
    if (!(J.norm() * inverse.norm() <= where.max_condition)) return false;
    const ph::task_vector<M> off = x - mechanism.position(q);
    if (off.norm() < 1e-9) return true;
    q += inverse * off;
  }
  return false;
}

// Corner number k of a seed, with inner angles [deg] in this range: within reach from 5 mm inside the walls
// on, and such that locked brakes hold 2 N with a tenth to spare.
template <class M>
corner<M> draw_corner(const corner_device<M>& device, int walls, double least_angle, double largest_angle,
                      std::uint64_t seed, std::size_t number) {
  constexpr int d = M::task_dimension;
  using V = ph::vector<double, d>;
  auto bits = ph::random_bits(seed, number);
  const auto between = [&](double low, double high) { return low + (high - low) * ph::uniform_number(bits); };
  const auto direction = [&] {
    const V u = V::NullaryExpr([&] { return ph::normal_number(bits); });
    return V(u.normalized());
  };
  for (int trial = 0; trial < 100000; ++trial) {
    corner<M> c;
    for (int i = 0; i < M::dof; ++i) c.q[i] = between(device.where.lower[i], device.where.upper[i]);
    c.apex = device.mechanism.position(c.q);
    const V first = direction(), u = direction(), side = (u - first * first.dot(u)).normalized();
    const double turn = ph::radians(180 - between(least_angle, largest_angle));
    c.out = {first, std::cos(turn) * first + std::sin(turn) * side};
    V along = side;  // wall 0, away from the others
    if constexpr (d == 3)
      if (walls == 3) {
        // The edge of walls 0 and 1, cut by a wall at such an angle to both of them
        const V edge = first.cross(side), middle = (c.out[0] + c.out[1]).normalized();
        const double lean = ph::radians(between(-30, 30));
        c.out.push_back(std::cos(lean) * edge + std::sin(lean) * middle);
        along = (side + edge).normalized();
      }
    V push = V::Zero();
    for (const V& n : c.out) push -= between(0.2, 1) * n;
    c.push = push.normalized();
    c.start = c.apex + device.where.path_length * along + 1e-3 * first;
    c.need = needed_share<M>(device.mechanism, device.brakes.torque_limit, c.q, 2 * c.push);
    if (!(c.need < 1 / 1.1)) continue;
    ph::joint_vector<M> q = c.q;
    if (!move_to(device.mechanism, device.where, V(c.apex + 5e-3 * c.push), q)) continue;
    if (!move_to(device.mechanism, device.where, c.start, c.q)) continue;
    return c;
  }
  throw std::logic_error("no corner of this device can be held");
}

}  // namespace experiments
