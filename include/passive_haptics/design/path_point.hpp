/// Points on a path along a wall.
#pragma once

#include <passive_haptics/mechanism/mechanism.hpp>

namespace passive_haptics {

/// A point on a path along a wall. A path is a function of u in (0, 1).
template <class M>
struct path_point {
  joint_vector<M> q;         ///< Joint positions [rad or m].
  task_vector<M> direction;  ///< Direction of motion of the end effector, base frame.
  task_vector<M> normal;     ///< Outward normal of the wall, base frame.
};

}  // namespace passive_haptics
