/// Brake torques for several contacts.
#pragma once

#include <passive_haptics/brake/at_rest/settled_rates.hpp>
#include <passive_haptics/core/linear/least_squares_by_priority.hpp>
#include <passive_haptics/core/nth.hpp>
#include <passive_haptics/core/scalar/difference_of_products.hpp>
#include <passive_haptics/force/torques/nearest_torque.hpp>
#include <passive_haptics/force/torques/torque_units.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace passive_haptics {

/// Demand of one of several contacts on the brakes.
template <class T, int D>
struct contact_demand {
  vector<T, D> normal;  ///< Outward unit normal n_j.
  T force;              ///< Desired n_j . F = a_j [N], >= 0.
  bool has_priority;    ///< Met before the others: a contact that is being left, where no normal force may
                        ///< remain.
};

/// Forces F = G t of torques with P t = 0. P is 0 for n = d, except at singular poses.
template <class T, int D, int Brakes>
struct force_map {
  matrix<T, D, Brakes> G;  ///< [N per N m]
  /// Component of torques that moves the device but not the end effector.
  matrix<T, Brakes, Brakes> P = matrix<T, Brakes, Brakes>::Zero();
};

/// Force map of a device with t = E^T F: G is the pseudo-inverse of E^T, which is also defined at singular
/// poses. Cost: one m x d decomposition; for 2 x 2 the inverse, to a few roundings per entry.
template <class T, int D, int Brakes>
force_map<T, D, Brakes> invert_brake_jacobian(const matrix<T, D, Brakes>& E) {
  constexpr T tolerance = rounding_tolerance<T>(Brakes);
  if constexpr (D == 2 && Brakes == 2) {
    const T det = difference_of_products(E(0, 0), E(1, 1), E(0, 1), E(1, 0));
    if (std::abs(det) > tolerance * E.colwise().squaredNorm().maxCoeff())
      return {matrix_of<2, 2>(E(1, 1), -E(1, 0), -E(0, 1), E(0, 0)) / det};
  }
  const orthogonal_decomposition<T, Brakes, D> Et(transposed(E), tolerance);
  force_map<T, D, Brakes> map{Et.pseudo_inverse()};
  if (Et.rank() < Brakes) map.P = Et.left_null_projection();
  return map;
}

/// Force map of a device with self-motion: F = (T J^+)^T t for torques with (T N)^T t = 0.
template <class M>
force_map<typename M::scalar, M::task_dimension, M::brake_count> force_map_of(const settled_rates<M>& rates) {
  constexpr int m = M::brake_count, rows = m < M::dof ? m : M::dof;
  force_map<typename M::scalar, M::task_dimension, m> map{rates.least_norm_rates().transpose()};
  map.P.template topRows<rows>() = rates.of_self_motion().transpose().template topRows<rows>();
  return map;
}

/// Least-norm torques in the box that do not affect the self-motion, with G t nearest to Fd: the nearest
/// force within limits for n > d. Without limits, see nearest_force. Cost:
/// core/linear/least_squares_by_priority.hpp, three levels.
template <class T, int D, int Brakes>
nearest_torque_result<T, D, Brakes> nearest_torque(const force_map<T, D, Brakes>& map,
                                                   const torque_box<T, Brakes>& box, const vector<T, D>& Fd) {
  const vector<T, Brakes> t = least_squares_by_priority(box.lower, box.upper, least_squares_level{map.P},
                                                        least_squares_level{map.G, Fd},
                                                        least_squares_level{identity_matrix<T, Brakes>()});
  return {t, map.G * t};
}

/// Torques for several contacts and the displayed force of each.
template <class T, int D, int Brakes, int Capacity>
struct contact_forces_result {
  vector<T, Brakes> torque;                                     ///< t [N m], exactly in the box.
  vector<T, D> force;                                           ///< F = G t [N].
  std::array<T, static_cast<std::size_t>(Capacity)> displayed;  ///< n_j . F [N]; 0 beyond the demands.
};

/// Torques t in the box with F = G t such that, in this order of priority: n_j . F = a_j for each demand with
/// priority; least squares for the other demands; least |F| (drag); least |t / u|. One demand with priority
/// gives F = alpha Fc of (12). Opposed walls do not cancel, and a demand of 5e4 N does not affect one of 2 N
/// with priority. Cost: core/linear/least_squares_by_priority.hpp, five levels. drag: minimises |drag t|
/// instead of |F|. u: units from form_of<M>::units.
template <class T, int D, int Brakes, int Capacity, class Units = equal_units>
contact_forces_result<T, D, Brakes, Capacity> contact_forces(
    const force_map<T, D, Brakes>& map, const torque_box<T, Brakes>& box,
    const std::array<contact_demand<T, D>, static_cast<std::size_t>(Capacity)>& demands, int count,
    const matrix<T, D, Brakes>& drag, const Units& u = Units()) {
  using demand_level = least_squares_level<T, Capacity, Brakes>;
  constexpr T eps = std::numeric_limits<T>::epsilon(), max_force = 1 / (eps * eps);  // [N m], of no brake
  demand_level first, others;
  for (int j = 0; j < count; ++j) {
    const auto& demand = nth(demands, j);
    demand_level& level = demand.has_priority ? first : others;
    level.A.row(j) = demand.normal.transpose() * map.G;
    level.b[j] = std::min(demand.force, max_force * level.A.row(j).norm());  // avoids overflow of torques
  }
  const vector<T, Brakes> t = least_squares_by_priority<Brakes + Capacity + D>(
      box.lower, box.upper, least_squares_level{map.P}, first, others, least_squares_level{drag},
      min_torque_level<T, Brakes>(u));

  contact_forces_result<T, D, Brakes, Capacity> result{t, map.G * t, {}};
  for (int j = 0; j < count; ++j) {
    const auto at = static_cast<std::size_t>(j);
    result.displayed[at] = demands[at].normal.dot(result.force);
  }
  return result;
}

/// As above, minimising |F|.
template <class T, int D, int Brakes, int Capacity>
contact_forces_result<T, D, Brakes, Capacity> contact_forces(
    const force_map<T, D, Brakes>& map, const torque_box<T, Brakes>& box,
    const std::array<contact_demand<T, D>, static_cast<std::size_t>(Capacity)>& demands, int count) {
  return contact_forces<T, D, Brakes, Capacity>(map, box, demands, count, map.G);
}

}  // namespace passive_haptics
