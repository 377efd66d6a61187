/// @file
/// A brake behind a driver that inverts its model.
#pragma once

#include <passive_haptics/brake/models/brake_model.hpp>

namespace passive_haptics {

/// Model behind a driver that inverts it: the command is the torque [N m] that the brake shall end in.
template <InvertibleBrakeModel Model>
struct compensated_brake {
  using scalar = typename Model::scalar;  ///< Scalar.
  using state = typename Model::state;    ///< What it remembers.

  Model model = {};  ///< The brake.

  /// See BrakeModel.
  brake_resistance<scalar> advance(scalar dt, scalar torque, scalar rate, state& now) const noexcept {
    return model.advance(dt, model.command_for(torque, rate, now), rate, now);
  }

  /// That of the brake [N m].
  scalar torque_limit_at(scalar rate) const noexcept { return model.torque_limit_at(rate); }

  /// The torque itself.
  scalar command_for(scalar torque, scalar /*rate*/, const state&) const noexcept { return torque; }

  /// That of the brake.
  brake_resistance<scalar> residual() const { return residual_of(model); }
  /// That of the brake [rad/(N m)].
  scalar compliance() const { return compliance_of(model); }

  /// The table of core/parameters.hpp, of a model that has one.
  static constexpr auto members()
    requires Parameters<Model>
  {
    return member_table(member("model", &compensated_brake::model));
  }
};

}  // namespace passive_haptics
