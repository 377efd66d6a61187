/// @file
/// The paper's two ways to control: with and without direct control.
#pragma once

#include <passive_haptics/control/control_law.hpp>

namespace passive_haptics {

/// The approximated force as it is, alpha = 1: what makes the hand bounce off a wall (section 3).
struct no_direct_control {
  static constexpr bool needs_hand_force = false;  ///< Runs without a force sensor.
  static constexpr bool gives_way = false;         ///< Displays all that is desired.
  static constexpr bool needs_dynamics = false;    ///< Knows no inertia.
  static constexpr bool needs_brake_lag = false;   ///< Knows no lag.
  struct memory {};                                ///< None.

  /// alpha = 1.
  template <class T, int D>
  T scale(const contact_situation<T, D>&, memory&) const noexcept {
    return T(1);
  }
};

/// Direct control (7)-(12): where the handle moves outward, the brakes are scaled so that nothing of the
/// resultant force Fr = Fh + alpha Fc is left normal to the wall.
///
/// Since Fc . Fd = |Fd|^2 after the approximation, (12) reads alpha = -Fh . n / |Fd|, limited to [0, 1].
struct direct_control {
  static constexpr bool needs_hand_force = true;  ///< Needs a force sensor at the handle.
  static constexpr bool gives_way = true;         ///< Leaves nothing normal where the handle moves out.
  static constexpr bool needs_dynamics = false;   ///< Knows no inertia.
  static constexpr bool needs_brake_lag = false;  ///< Knows no lag.
  struct memory {};                               ///< None.

  /// alpha = clamp(-Fh . n / |Fd|, 0, 1) if Fd . v > 0, else 1 (step 2 of section 4).
  template <class T, int D>
  T scale(const contact_situation<T, D>& c, memory&) const noexcept {
    if (!(c.normal_velocity > T(0))) return T(1);
    const T pressing = -dot(c.hand_force, c.normal);
    if (!(pressing > T(0))) return T(0);
    return pressing < c.desired_magnitude ? pressing / c.desired_magnitude : T(1);
  }
};

}  // namespace passive_haptics
