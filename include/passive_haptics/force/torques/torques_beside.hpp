/// Brake torques for effects in addition to walls.
#pragma once

#include <passive_haptics/force/torques/contact_forces.hpp>

#include <algorithm>

namespace passive_haptics {

/// Demand of effects on the brakes.
template <class T, int D, int Brakes, int Joints>
struct effect_demand {
  vector<T, D> force;                    ///< Desired force Fe at the end effector [N].
  matrix<T, Joints, Brakes> joint_rows;  ///< Rows of T^T for joints with an effect torque, else 0.
  vector<T, Joints> joint_torque;        ///< Additional torque of these joints [N m].
};

/// Torques in the box that keep the normal forces n_j . G t of the walls and then satisfy, in this order of
/// priority: the joint torques; no self-motion; G t nearest to Fe; least |t / u|, u = form_of<M>::units.
/// normals: n_j in rows, 0 beyond the walls. t must be in the box. Solves for the change of t, so that a wall
/// of 5e4 N and an effect of 2 N do not affect each other by rounding. Cost:
/// core/linear/least_squares_by_priority.hpp, five levels.
template <class T, int D, int Brakes, int Walls, int Joints, class Units = equal_units>
vector<T, Brakes> torques_beside(const force_map<T, D, Brakes>& map, const torque_box<T, Brakes>& box,
                                 const vector<T, Brakes>& t, const matrix<T, Walls, D>& normals,
                                 const effect_demand<T, D, Brakes, Joints>& wanted,
                                 const Units& u = Units()) {
  // Only the tangential component is available
  const orthogonal_decomposition<T, Walls, D> walls(normals, rounding_tolerance<T>(Walls));
  const vector<T, D> missing = walls.without_row_space(wanted.force - map.G * t);
  vector<T, Brakes> sum =
      t + least_squares_by_priority(vector<T, Brakes>(box.lower - t), vector<T, Brakes>(box.upper - t),
                                    least_squares_level{matrix<T, Walls, Brakes>(normals * map.G)},
                                    least_squares_level{wanted.joint_rows, wanted.joint_torque},
                                    least_squares_level{map.P}, least_squares_level{map.G, missing},
                                    min_torque_level<T, Brakes>(u, vector<T, Brakes>(-t)));
  for (int i = 0; i < Brakes; ++i) sum[i] = std::clamp(sum[i], box.lower[i], box.upper[i]);
  return sum;
}

}  // namespace passive_haptics
