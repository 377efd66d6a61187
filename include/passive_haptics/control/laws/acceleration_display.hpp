/// @file
/// How the brakes accelerate the end effector, and the torques that give walls the normal accelerations they
/// want.
#pragma once

#include <passive_haptics/brake/signs.hpp>
#include <passive_haptics/control/control_law.hpp>
#include <passive_haptics/force/torques/contact_forces.hpp>
#include <passive_haptics/mechanism/dynamically_consistent_inverse.hpp>
#include <passive_haptics/mechanism/dynamics.hpp>
#include <passive_haptics/mechanism/jacobian.hpp>

#include <array>
#include <cmath>

namespace passive_haptics {

/// How brake torques t accelerate the end effector, xdd = free + G t, and the brakes' own axes, wd =
/// brakes_free + A t.
template <class T, int D, int Brakes>
struct acceleration_map {
  vector<T, D> free;              ///< J M^-1 (J^T Fh - c) + Jd qd [m/s^2]
  matrix<T, D, Brakes> G;         ///< J M^-1 T^T [m/s^2 per N m]
  vector<T, Brakes> brakes_free;  ///< T M^-1 (J^T Fh - c) [rad/s^2]; Td qd is left out.
  matrix<T, Brakes, Brakes> A;    ///< T M^-1 T^T [rad/s^2 per N m]
  /// The forces at the end effector that accelerate it as unit torques do [N per N m]; G itself at a singular
  /// pose.
  matrix<T, D, Brakes> forces;

  /// Torque [N m] that keeps brake i from accelerating while the others make t.
  T holding_torque(int i, const vector<T, Brakes>& t) const {
    return -(brakes_free[i] + A.row(i).dot(t) - A(i, i) * t[i]) / A(i, i);
  }

  /// The map of the device with brake i held, whatever torque that takes; t_i has no effect any more.
  acceleration_map held(int i) const {
    acceleration_map map = *this;
    const matrix<T, 1, Brakes> row = A.row(i) / A(i, i);
    const T alone = brakes_free[i] / A(i, i);
    map.free -= G.col(i) * alone;
    map.G -= G.col(i) * row;
    map.forces -= forces.col(i) * row;
    map.brakes_free -= A.col(i) * alone;
    map.A -= A.col(i) * row;
    map.G.col(i).setZero();
    map.forces.col(i).setZero();
    return map;
  }
};

/// The acceleration map of a mechanism with inertia, the hand doing Fh to it. Cost: two Choleskys of n x n
/// and an orthogonal decomposition of n x d.
template <class M, class EMatrix, class B>
auto accelerations(const brake_situation<M, EMatrix, B>& now) {
  static_assert(Dynamics<M>,
                "passive_haptics: this law needs a mechanism that models Dynamics (mechanism/dynamics.hpp).");
  using T = typename M::scalar;
  constexpr int n = M::dof, d = M::task_dimension, m = M::brake_count;
  const matrix<T, d, n> J(jacobian(now.mechanism, now.q));
  const matrix<T, n, m> Tt = transposed_transmission(now.mechanism, now.q);
  const matrix<T, n, n> inertia = now.mechanism.mass_matrix(now.q);
  const cholesky<T, n> mass(inertia);
  const joint_vector<M> torque = J.transpose() * now.hand_force - now.mechanism.bias_torque(now.q, now.qd);
  const joint_vector<M> qdd = mass.solve(torque);
  const matrix<T, n, m> per_torque = mass.solve(Tt);
  acceleration_map<T, d, m> map;
  map.free = J * qdd + now.mechanism.bias_acceleration(now.q, now.qd);
  map.G = J * per_torque;
  map.brakes_free = Tt.transpose() * qdd;
  map.A = Tt.transpose() * per_torque;
  map.forces = dynamically_consistent_inverse<T, n, d>(J, inertia).forces(Tt);
  if (!all_finite(map.forces)) map.forces = map.G;
  return map;
}

/// Normal accelerations that walls want of the end effector, at least.
template <class T, int D, int Capacity>
class wanted_accelerations {
 public:
  /// n . xdd >= least [m/s^2]
  void add(const vector<T, D>& n, T least) { walls_[static_cast<std::size_t>(count_++)] = {n, least}; }

  /// Torques in the box that add what is missing, as near as may be, with the least force at the end
  /// effector.
  template <int Brakes>
  vector<T, Brakes> torques(const acceleration_map<T, D, Brakes>& map,
                            const torque_box<T, Brakes>& box) const {
    std::array<contact_demand<T, D>, static_cast<std::size_t>(Capacity)> demands;
    int count = 0;
    for (int j = 0; j < count_; ++j) {
      const auto& [n, least] = walls_[static_cast<std::size_t>(j)];
      const T missing = least - n.dot(map.free);
      if (missing > T(0)) demands[static_cast<std::size_t>(count++)] = {n, missing, false};
    }
    if (count == 0) return vector<T, Brakes>::Zero();
    const force_map<T, D, Brakes> G{map.G, {}, false};
    return contact_forces<T, D, Brakes, Capacity>(G, box, demands, count, map.forces).torque;
  }

 private:
  struct wall {
    vector<T, D> normal;
    T least;
  };
  std::array<wall, static_cast<std::size_t>(Capacity)> walls_;
  int count_ = 0;
};

/// Torques [N m] that come nearest to the wanted accelerations, knowing that a brake at rest makes no more
/// than what holds it: where it would be told more, it is held, and the others do the rest for the device
/// with that brake held. (Without this the handle slides into a wall along the path that a brake at rest
/// leaves it.)
template <class M, class EMatrix, int D, int Capacity, class B>
brake_vector<M> nearest_torques(const brake_situation<M, EMatrix, B>& now,
                                const wanted_accelerations<typename M::scalar, D, Capacity>& wanted) {
  using T = typename M::scalar;
  constexpr int m = M::brake_count;
  const auto box = torques_within(now.s, torque_limits_of<T, m>(now.brakes));
  auto map = accelerations(now);
  brake_vector<M> t = wanted.torques(map, box), told = brake_vector<M>::Zero();
  std::array<bool, static_cast<std::size_t>(m)> is_held{};
  for (int i = 0; i < m; ++i) {
    if (is_held[static_cast<std::size_t>(i)] || slips(now.w[i], rate_dead_band_of<T>(now.brakes, i)))
      continue;
    const T holding = map.holding_torque(i, t);
    if (!(t[i] * holding > T(0) && std::abs(t[i]) >= std::abs(holding))) continue;
    is_held[static_cast<std::size_t>(i)] = true;
    told[i] = t[i];
    map = map.held(i);
    t = wanted.torques(map, box);
    i = -1;  // the others anew
  }
  return t + told;
}

}  // namespace passive_haptics
