/// @file
/// A brake whose driver knows its model.
#pragma once

#include <passive_haptics/brake/models/brake_model.hpp>

namespace passive_haptics {

/// Model behind a driver that inverts it: the command is the torque [N m] that the brake shall end in.
template <InvertibleBrakeModel Model>
struct compensated_brake : Model {
  using scalar = typename Model::scalar;  ///< Scalar.
  using typename Model::state;

  /// See BrakeModel.
  brake_resistance<scalar> advance(scalar dt, scalar torque, scalar rate, state& now) const noexcept {
    return Model::advance(dt, Model::command_for(torque, rate, now), rate, now);
  }

  /// The torque itself.
  scalar command_for(scalar torque, scalar /*rate*/, const state&) const noexcept { return torque; }
};

}  // namespace passive_haptics
