/// Direct control with limited torques before alpha.
#pragma once

#include <passive_haptics/control/direct_control.hpp>

namespace passive_haptics {

/// Direct control as in the paper's experiments: alpha (12) scales torques that are already limited.
///
/// Section 5.2: "The scale factor alpha is nearly zero to compensate for a very large desired force (5x10^4
/// N) with small hand force inputs (below 2 N)". In a wall of 1e7 N/m all brakes are at their limits, so an
/// alpha of 4e-5 releases them outward. In direct_control they would keep the torque that cancels the hand
/// force.
///
/// With brakes that are just strong enough (a normal force of 1.4 to 3 times the hand's push) and a compliant
/// hand, this reproduces Figs. 8 to 10. With stronger brakes it chatters (docs/results.md). For one contact.
struct saturated_direct_control {
  static constexpr bool needs_hand_force = true;    ///< Needs a force sensor at the handle.
  static constexpr bool nulls_normal_force = true;  ///< Removes the normal force while the handle moves out.
  static constexpr bool saturates_before_scaling = true;  ///< Limits torques before alpha.

  double velocity_dead_band = 0;  ///< v_dead [m/s], >= 0; 0 as in the paper.

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
