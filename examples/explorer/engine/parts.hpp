/// @file
/// A device as its settings describe it: what the other files of the engine work on.
#pragma once

#include "configuration.hpp"

#include <memory>

namespace explorer {

/// Settings, and what is made of them.
struct device_parts {
  configuration settings;                             ///< All of them.
  std::unique_ptr<runtime::any_mechanism> mechanism;  ///< The mechanism.
  std::unique_ptr<device_kind> kind;                  ///< Its compiled functions.
  wall_shape wall;                                    ///< The wall.

  /// Throws std::invalid_argument, also if the chain does not close at the joint positions.
  explicit device_parts(const configuration& given);

  int n() const { return settings.sizes.dof; }             ///< Joints.
  int d() const { return settings.sizes.task_dimension; }  ///< Dimension of the task.
  int m() const { return settings.sizes.brake_count; }     ///< Brakes.

  /// The handle [m].
  place position(numbers q) const { return place_of(mechanism->position(q)); }
  /// The columns of J, one for each joint.
  std::array<place, runtime::max_joints> jacobian(numbers q) const;
  /// Velocity of the handle [m/s].
  place velocity(numbers q, numbers qd) const;
  /// Joint positions that put the handle at x [m], on the branch of `from`; by a formula of the mechanism,
  /// else by steps of its Jacobian, with status::out_of_reach at the nearest place.
  runtime::any_mechanism::joint_pose inverse(const place& x, numbers from) const;
  /// Throws std::invalid_argument if the hand moves along a wall and there is none.
  void require_wall_for_hand() const;
};

}  // namespace explorer
