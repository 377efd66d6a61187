/// @file
/// On how much of a path no law can hold a hand.
#pragma once

#include <passive_haptics/design/displayable.hpp>

namespace passive_haptics {

/// A place on a path along a wall.
template <class M>
struct path_point {
  joint_vector<M> q;         ///< Joint positions [rad or m].
  task_vector<M> direction;  ///< In which the end effector moves, base frame.
  task_vector<M> normal;     ///< Of the wall there, out of it, base frame.
};

/// Share [1] of a path on which brakes of these limits [N m] cannot display `push` [N] against the wall; with
/// push = 0 that on which they can display nothing, whatever their limits. Poses without a result count.
///
/// path(u) returns the path_point<M> at u in (0, 1). Called at the middles of `samples` >= 1 equal parts.
/// Cost: that of `displayable` for each.
template <class M, class Path>
double undisplayable_share(const M& mechanism, Path&& path,
                           const brake_vector<M>& torque_limit =
                               brake_vector<M>::Constant(std::numeric_limits<typename M::scalar>::infinity()),
                           typename M::scalar push = 0, int samples = 200) {
  int weak = 0;
  for (int k = 0; k < samples; ++k) {
    const path_point<M> at = path((k + 0.5) / samples);
    weak += !(displayable(mechanism, at.q, at.direction, at.normal, torque_limit).strongest > push);
  }
  return static_cast<double>(weak) / samples;
}

}  // namespace passive_haptics
