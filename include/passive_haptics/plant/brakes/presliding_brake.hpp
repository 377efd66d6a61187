/// @file
/// A brake that twists before it slips.
#pragma once

#include <passive_haptics/brake/models/brake_model.hpp>

namespace passive_haptics {

/// Model behind an elastic shaft: a spring in series with its friction,
///
///     |t| <= strength,   dt/dt = -w / compliance   while it does not slip,
///
/// with t its friction torque and w the rate of its axis (Prandtl's element). The spring's stiffness does not
/// depend on the command, so the brake gives back what the spring took and no more. A brake whose strength
/// falls slips, and dissipates what the spring held.
template <BrakeModel Model>
struct presliding_brake {
  using scalar = typename Model::scalar;  ///< Scalar.
  using state = typename Model::state;    ///< What it remembers; the device remembers the twist.

  Model model = {};  ///< The brake.
  /// Twist at which the brake slips under its full torque [rad]; assumed.
  scalar presliding = scalar(0.003);

  /// See BrakeModel.
  brake_resistance<scalar> advance(scalar dt, scalar command, scalar rate, state& now) const noexcept {
    return model.advance(dt, command, rate, now);
  }

  /// That of the brake [N m].
  scalar torque_limit_at(scalar rate) const noexcept { return model.torque_limit_at(rate); }

  /// The command of the brake, where it can be found: the torque once it slips.
  scalar command_for(scalar torque, scalar rate, const state& now) const noexcept
    requires InvertibleBrakeModel<Model>
  {
    return model.command_for(torque, rate, now);
  }

  /// That of the brake.
  brake_resistance<scalar> residual() const { return residual_of(model); }

  /// Twist for each N m [rad/(N m)], with that of the brake.
  scalar compliance() const {
    const scalar limit = model.torque_limit_at(scalar(0));
    return compliance_of(model) + (limit > scalar(0) ? presliding / limit : scalar(0));
  }

  /// The table of core/parameters.hpp, with that of the model if it has one.
  static constexpr auto members() {
    using p = presliding_brake;
    constexpr auto own = member("presliding", &p::presliding, "rad", range::not_negative);
    if constexpr (Parameters<Model>) return member_table(member("model", &p::model), own);
    else return member_table(own);
  }
};

}  // namespace passive_haptics
