/// @file
/// Result of inverse kinematics.
#pragma once

#include <passive_haptics/core/matrix.hpp>
#include <passive_haptics/core/status.hpp>

namespace passive_haptics {

/// Joint positions that reach a point, or the pose nearest to it with status::out_of_reach.
template <class T, int Dof>
struct joint_solution {
  vector<T, Dof> q;             ///< Joint positions [rad or m]; NaN if the point is not finite.
  status outcome = status::ok;  ///< ok, out_of_reach or state_not_finite.
};

}  // namespace passive_haptics
