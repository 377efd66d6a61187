/// @file
/// The paper's two ways to control: with and without direct control.
#pragma once

#include <passive_haptics/control/control_law.hpp>
#include <passive_haptics/core/validate.hpp>

#include <string>

namespace passive_haptics {

/// The approximated force as it is, alpha = 1: what makes the hand bounce off a wall (section 3).
struct no_direct_control {
  static constexpr bool needs_hand_force = false;       ///< Runs without a force sensor.
  static constexpr bool gives_way = false;              ///< Displays all that is desired.
  static constexpr bool needs_dynamics = false;         ///< Knows no inertia.
  static constexpr bool needs_brake_lag = false;        ///< Knows no lag.
  static constexpr bool needs_normal_velocity = false;  ///< Does the same whichever way the handle moves.
  struct memory {};                                     ///< None.

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
///
/// With a dead band the normal force is nulled before the handle moves out, which holds off part of the
/// brakes' lag; it then sinks at up to v_dead. Of several contacts only those that are being left (n . v > 0)
/// come first.
struct direct_control {
  static constexpr bool needs_hand_force = true;  ///< Needs a force sensor at the handle.
  static constexpr bool gives_way = true;         ///< Leaves nothing normal where the handle moves out.
  static constexpr bool needs_dynamics = false;   ///< Knows no inertia.
  static constexpr bool needs_brake_lag = false;  ///< Knows no lag.
  struct memory {};                               ///< None.

  double velocity_dead_band = 0;  ///< v_dead [m/s], >= 0; 0 is (12) as printed.

  /// alpha = clamp(-Fh . n / |Fd|, 0, 1) if n . v > -v_dead, else 1 (step 2 of section 4).
  template <class T, int D>
  T scale(const contact_situation<T, D>& c, memory&) const noexcept {
    if (!(c.normal_velocity > -static_cast<T>(velocity_dead_band))) return T(1);
    const T pressing = -dot(c.hand_force, c.normal);
    if (!(pressing > T(0))) return T(0);
    return pressing < c.desired_magnitude ? pressing / c.desired_magnitude : T(1);
  }
};

/// What is wrong with the law's dead band; empty if nothing.
inline std::string validate(const direct_control& law) {
  return detail::check_not_negative("velocity_dead_band [m/s]", law.velocity_dead_band);
}

}  // namespace passive_haptics
