/// @file
/// Brake torques for effects, beside what walls already have.
#pragma once

#include <passive_haptics/force/torques/contact_forces.hpp>

#include <algorithm>

namespace passive_haptics {

/// What effects demand of the brakes.
template <class T, int D, int Brakes, int Joints>
struct effect_demand {
  vector<T, D> force;                    ///< Fe, wanted force at the end effector [N].
  matrix<T, Joints, Brakes> joint_rows;  ///< Rows of T^T for joints with a torque of their own, else 0.
  vector<T, Joints> joint_torque;        ///< What these joints shall have more than t gives them [N m].
};

/// Torques in the box that keep n_j . G t, the normal forces that t displays, and with what is left do, in
/// this order of priority: the torques of joints; no self-motion; the force G t nearest to Fe; the least
/// |t / u|, u being units from form_of<M>::units.
///
/// normals: n_j in rows, 0 beyond the walls. t in the box. Solved for the change of t, so that a wall of 5e4
/// N leaves none of its rounding on an effect of 2 N, nor an effect any on the wall. Cost:
/// core/linear/least_squares_by_priority.hpp, five levels.
template <class T, int D, int Brakes, int Walls, int Joints, class Units = equal_units>
vector<T, Brakes> torques_beside(const force_map<T, D, Brakes>& map, const torque_box<T, Brakes>& box,
                                 const vector<T, Brakes>& t, const matrix<T, Walls, D>& normals,
                                 const effect_demand<T, D, Brakes, Joints>& wanted,
                                 const Units& u = Units()) {
  // Along the walls alone: the rest is not to be had
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
