/// Brakes with a driver that inverts their model.
#pragma once

#include <passive_haptics/brake/models/brake_model.hpp>

namespace passive_haptics {

/// Model with a driver that inverts it: the command is the desired final torque [N m].
template <InvertibleBrakeModel Model>
struct compensated_brake {
  using scalar = typename Model::scalar;  ///< Scalar.
  using state = typename Model::state;    ///< As the model.

  Model model = {};  ///< The brake.

  /// As BrakeModel.
  brake_resistance<scalar> advance(scalar dt, scalar torque, scalar rate, state& now) const noexcept {
    return model.advance(dt, model.command_for(torque, rate, now), rate, now);
  }

  /// As the model [N m].
  scalar torque_limit_at(scalar rate) const noexcept { return model.torque_limit_at(rate); }

  /// The torque itself.
  scalar command_for(scalar torque, scalar /*rate*/, const state&) const noexcept { return torque; }

  brake_resistance<scalar> residual() const { return residual_of(model); }  ///< As the model.
  scalar compliance() const { return compliance_of(model); }                ///< As the model [rad/(N m)].

  static constexpr auto members()
    requires Parameters<Model>
  {
    return member_table(member("model", &compensated_brake::model));
  }
};

}  // namespace passive_haptics
