/// Brakes that twist before they slip.
#pragma once

#include <passive_haptics/brake/models/brake_model.hpp>

namespace passive_haptics {

/// Model with an elastic shaft, a spring in series with its friction (Prandtl's element),
///
///     |t| <= strength,   dt/dt = -w / compliance   while it does not slip,
///
/// with friction torque t and rate w of its axis. The brake returns at most the energy stored in the spring;
/// if its strength falls, it slips and dissipates that energy.
template <BrakeModel Model>
struct presliding_brake {
  using scalar = typename Model::scalar;  ///< Scalar.
  using state = typename Model::state;    ///< As the model; the device stores the twist.

  Model model = {};  ///< The brake.
  /// Twist at which the brake slips under its full torque [rad]; assumed.
  scalar presliding = scalar(0.003);

  /// As BrakeModel.
  brake_resistance<scalar> advance(scalar dt, scalar command, scalar rate, state& now) const noexcept {
    return model.advance(dt, command, rate, now);
  }

  /// As the model [N m].
  scalar torque_limit_at(scalar rate) const noexcept { return model.torque_limit_at(rate); }

  /// As the model, if that is invertible: the torque once it slips.
  scalar command_for(scalar torque, scalar rate, const state& now) const noexcept
    requires InvertibleBrakeModel<Model>
  {
    return model.command_for(torque, rate, now);
  }

  brake_resistance<scalar> residual() const { return residual_of(model); }  ///< As the model.

  /// Compliance of shaft and model [rad/(N m)].
  scalar compliance() const {
    const scalar limit = model.torque_limit_at(scalar(0));
    return compliance_of(model) + (limit > scalar(0) ? presliding / limit : scalar(0));
  }

  static constexpr auto members() {
    using p = presliding_brake;
    constexpr auto own = member("presliding", &p::presliding, "rad", range::not_negative);
    if constexpr (Parameters<Model>) return member_table(member("model", &p::model), own);
    else return member_table(own);
  }
};

}  // namespace passive_haptics
