/// The paper's laws: with and without direct control (section 4).
#pragma once

#include <passive_haptics/control/control_law.hpp>
#include <passive_haptics/core/linear/lanes.hpp>
#include <passive_haptics/core/parameters.hpp>

namespace passive_haptics {

/// Displays the whole approximated force, alpha = 1; the hand then bounces off walls (section 3).
struct no_direct_control {
  /// alpha = 1.
  template <class T, int D>
  T scale(const contact_situation<T, D>&) const noexcept {
    return T(1);
  }
};

/// Direct control: while the handle moves outward, the resultant force has no normal component. It is
///
///     Fr = Frn + Frt = Fh + alpha Fc,
/// @equation{7}
/// and its normal component has the magnitude
///
///     |Frn| = |Fr| cos(lambda),
/// @equation{8}
/// with the angle lambda between Fr and Fd,
///
///     cos(lambda) = Fr . Fd / (|Fr| |Fd|).
/// @equation{9}
/// Together
///
///     |Frn| = |Fh + alpha Fc| (Fh + alpha Fc) . Fd / (|Fr| |Fd|),
/// @equation{10}
/// which is zero if
///
///     (Fh + alpha Fc) . Fd = 0.
/// @equation{11}
///
/// After the approximation Fc . Fd = |Fd|^2, so alpha = -Fh . n / |Fd| with n = Fd / |Fd|, without division
/// by small numbers. It is limited to [0, 1]: no force if the hand pulls away, and at most the desired force.
///
/// A dead band removes the normal force before the handle moves out, which compensates part of the brake lag.
/// The handle then sinks at up to v_dead. With several contacts, those being left have priority.
struct direct_control {
  static constexpr bool needs_hand_force = true;    ///< Needs a force sensor at the handle.
  static constexpr bool nulls_normal_force = true;  ///< Removes the normal force while the handle moves out.

  double velocity_dead_band = 0;  ///< v_dead [m/s], >= 0; 0 as in the paper.

  static constexpr auto members() {
    using p = direct_control;
    return member_table(member("velocity_dead_band", &p::velocity_dead_band, "m/s", range::not_negative));
  }

  /// alpha = -Fh . Fd / (Fc . Fd) in [0, 1] if n . v > -v_dead, else 1 (step 2 of section 4).
  /// @equation{12}
  template <class T, int D>
  T scale(const contact_situation<T, D>& c) const noexcept {
    const T alpha = clamped(-c.hand_force.dot(c.normal) / c.desired_magnitude, T(0), T(1));
    return select(c.normal_velocity > -static_cast<T>(velocity_dead_band), alpha, T(1));
  }
};

}  // namespace passive_haptics
