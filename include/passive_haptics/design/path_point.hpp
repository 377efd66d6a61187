/// @file
/// A place on a path along a wall.
#pragma once

#include <passive_haptics/mechanism/mechanism.hpp>

namespace passive_haptics {

/// A place on a path along a wall. A path is a function of u in (0, 1), from its start to its end.
template <class M>
struct path_point {
  joint_vector<M> q;         ///< Joint positions [rad or m].
  task_vector<M> direction;  ///< In which the end effector moves, base frame.
  task_vector<M> normal;     ///< Of the wall there, out of it, base frame.
};

}  // namespace passive_haptics
