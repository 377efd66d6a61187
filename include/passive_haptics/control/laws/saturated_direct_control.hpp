/// @file
/// Direct control as the paper's experiments read it: alpha scales what the brakes can make.
#pragma once

#include <passive_haptics/control/direct_control.hpp>

namespace passive_haptics {

/// Direct control whose alpha (12) scales torques that are already cut to the brakes' limits.
///
/// Section 5.2: "The scale factor alpha is nearly zero to compensate for a very large desired force
/// (5x10^4 N) with small hand force inputs (below 2 N)". Behind a wall of 1e7 N/m the brakes are at their
/// limits whatever is desired, so an alpha of 4e-5 lets them go: outward the brakes are released, inward they
/// hold. In the order of direct_control, alpha first, they keep what cancels the hand's force.
///
/// With brakes that are just strong enough (a normal force of 1.4 to 3 times the hand's push) and a hand that
/// yields normal to the wall, this is what Figs. 8 to 10 show: separations end, the depth varies less, brake
/// 2 slips, less force retards the hand. With stronger brakes it chatters (docs/results.md). One contact at a
/// time.
struct saturated_direct_control {
  static constexpr bool needs_hand_force = true;    ///< Needs a force sensor at the handle.
  static constexpr bool nulls_normal_force = true;  ///< Leaves nothing normal where the handle moves out.
  static constexpr bool saturates_before_scaling = true;  ///< The limits come before alpha.

  double velocity_dead_band = 0;  ///< v_dead [m/s], >= 0; 0 is the law as printed.

  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = saturated_direct_control;
    return member_table(member("velocity_dead_band", &p::velocity_dead_band, "m/s", range::not_negative));
  }

  /// alpha of direct_control.
  template <class T, int D>
  T scale(const contact_situation<T, D>& c) const noexcept {
    return direct_control{velocity_dead_band}.scale(c);
  }
};

}  // namespace passive_haptics
