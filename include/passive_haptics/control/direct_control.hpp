/// @file
/// The paper's two ways to control: with and without direct control (section 4).
#pragma once

#include <passive_haptics/control/control_law.hpp>
#include <passive_haptics/core/linear/lanes.hpp>
#include <passive_haptics/core/parameters.hpp>

namespace passive_haptics {

/// The approximated force as it is, alpha = 1: what makes the hand bounce off a wall (section 3).
struct no_direct_control {
  /// alpha = 1.
  template <class T, int D>
  T scale(const contact_situation<T, D>&) const noexcept {
    return T(1);
  }
};

/// Direct control: where the handle moves outward, the brakes are scaled so that nothing of the resultant
/// force is left normal to the wall. The resultant is
///
///     Fr = Frn + Frt = Fh + alpha Fc,
/// @equation{7}
/// and its normal component has the size
///
///     |Frn| = |Fr| cos(lambda),
/// @equation{8}
/// where lambda is the angle between Fr and Fd, so
///
///     cos(lambda) = Fr . Fd / (|Fr| |Fd|).
/// @equation{9}
/// Together
///
///     |Frn| = |Fh + alpha Fc| (Fh + alpha Fc) . Fd / (|Fr| |Fd|),
/// @equation{10}
/// which vanishes where
///
///     (Fh + alpha Fc) . Fd = 0.
/// @equation{11}
///
/// After the approximation Fc . Fd = |Fd|^2. So with n = Fd / |Fd| alpha = -Fh . n / |Fd|, and nothing small
/// is divided by. It is limited to [0, 1]: a hand that pulls away needs no force, and a brake gives no more
/// than what is desired.
///
/// With a dead band the normal force is nulled before the handle moves out, which holds off part of the
/// brakes' lag. The handle then sinks at up to v_dead. Of several contacts those being left come first.
struct direct_control {
  static constexpr bool needs_hand_force = true;    ///< Needs a force sensor at the handle.
  static constexpr bool nulls_normal_force = true;  ///< Leaves nothing normal where the handle moves out.

  double velocity_dead_band = 0;  ///< v_dead [m/s], >= 0; 0 is the law as printed.

  /// The table of core/parameters.hpp.
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
