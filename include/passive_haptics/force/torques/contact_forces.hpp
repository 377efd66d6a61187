/// @file
/// One set of brake torques for several contacts.
#pragma once

#include <passive_haptics/force/torques/nearest_torque.hpp>

#include <array>
#include <cstddef>

namespace passive_haptics {

/// What one of several contacts asks of the brakes.
template <class T, int D>
struct contact_demand {
  vector<T, D> normal;  ///< n_j, unit, out of the wall.
  T force;              ///< a_j, wanted n_j . F [N], >= 0.
  bool first;           ///< Met before the others: a contact being left, where nothing may remain normal.
};

/// What the force F of the brakes at the end effector can be: F = G t, where P t = 0.
template <class T, int D, int Brakes>
struct force_map {
  matrix<T, D, Brakes> G;       ///< [N per N m]
  matrix<T, Brakes, Brakes> P;  ///< Of torques, what moves the device without moving the end effector.
  bool self_motion;             ///< False if P = 0: n = d away from singular poses, and redundant brakes.
};

/// The force map of a device whose torques and forces are tied by t = E^T F: G is the pseudo-inverse of E^T,
/// so it also answers at singular poses, for the forces that brakes can make there. Cost: one decomposition
/// of m x d.
template <class T, int D, int Brakes>
force_map<T, D, Brakes> invert_brake_jacobian(const matrix<T, D, Brakes>& E) {
  const orthogonal_decomposition<T, Brakes, D> Et(transposed(E), rounding_tolerance<T>(Brakes));
  return {Et.pseudo_inverse(), Et.left_null_projection(), Et.rank() < Brakes};
}

/// Torques for several contacts and what became of each.
template <class T, int D, int Brakes, int Capacity>
struct contact_forces_result {
  vector<T, Brakes> torque;                                     ///< t [N m], in the box exactly.
  vector<T, D> force;                                           ///< F = G t [N].
  std::array<T, static_cast<std::size_t>(Capacity)> displayed;  ///< n_j . F [N]; 0 beyond the demands.
};

/// Torques t in the box whose force F = G t gives, in this order of priority: n_j . F = a_j for every demand
/// that is first; as near as possible for the others, in the sum of squares; the least |F| (least drag); the
/// least |t|. One demand that is first gives F = alpha Fc of (12). Opposed walls do not cancel, and a demand
/// of 5e4 N does not drown one of 2 N that is first. Cost: core/linear/prioritised_least_squares.hpp, four
/// levels.
///
/// drag: what shall be least, |drag t|, where that is not |F|.
template <class T, int D, int Brakes, int Capacity>
contact_forces_result<T, D, Brakes, Capacity> contact_forces(
    const force_map<T, D, Brakes>& map, const torque_box<T, Brakes>& box,
    const std::array<contact_demand<T, D>, static_cast<std::size_t>(Capacity)>& demands, int count,
    const matrix<T, D, Brakes>& drag) {
  using solver = prioritised_least_squares<T, Brakes, Brakes + Capacity + D>;
  using rows = typename solver::rows;
  using targets = typename solver::targets;
  solver t(box.lower, box.upper);
  if (map.self_motion) {
    t.minimise(padded<solver::row_count>(map.P), targets::Zero());
  }
  for (const bool first : {true, false}) {
    rows A = rows::Zero();
    targets a = targets::Zero();
    int count_here = 0;
    for (int j = 0; j < count; ++j) {
      const auto& demand = demands[static_cast<std::size_t>(j)];
      if (demand.first != first) continue;
      A.row(count_here) = demand.normal.transpose() * map.G;
      a[count_here++] = demand.force;
    }
    if (count_here > 0) t.minimise(A, a);
  }
  t.minimise(padded<solver::row_count>(drag), targets::Zero());
  t.minimise(rows::Identity(), targets::Zero());

  contact_forces_result<T, D, Brakes, Capacity> result{t.solution(), map.G * t.solution(), {}};
  for (int j = 0; j < count; ++j) {
    const auto at = static_cast<std::size_t>(j);
    result.displayed[at] = demands[at].normal.dot(result.force);
  }
  return result;
}

/// The same with the least |F|.
template <class T, int D, int Brakes, int Capacity>
contact_forces_result<T, D, Brakes, Capacity> contact_forces(
    const force_map<T, D, Brakes>& map, const torque_box<T, Brakes>& box,
    const std::array<contact_demand<T, D>, static_cast<std::size_t>(Capacity)>& demands, int count) {
  return contact_forces<T, D, Brakes, Capacity>(map, box, demands, count, map.G);
}

}  // namespace passive_haptics
