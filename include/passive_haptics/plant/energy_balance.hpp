/// Energy balance of a simulated device.
#pragma once

namespace passive_haptics {

/// Energies of a simulated device since its motion was last set [J]. All works use the mid-point rate, so the
/// imbalance of a step from qd to qd' is
///
///     qd' . (M(q') - M(q)) qd' / 2  -  dt (c - g) . (qd + qd')/2,
///
/// and over a run
///
///     |imbalance| <= k dt sum |qd| (|work| + dt |qd| kinetic),
///
/// with k of order 1 per radian; rounding for a constant M.
struct energy_balance {
  double start = 0;              ///< Kinetic energy of device and hand at the start.
  double hand = 0;               ///< Work of the hand's muscles on the device.
  double gravity = 0;            ///< Work of gravity on the device.
  double brakes = 0;             ///< Dissipated by commanded torques, or stored by the brakes' compliance.
  double residual_friction = 0;  ///< Dissipated by the brakes' residual friction.
  double drag = 0;               ///< Dissipated by the brakes' residual drag.
  double kinetic = 0;            ///< Current kinetic energy of device and hand.
  /// Maximum power that the friction of one brake gave to the device in one step [W]; 0 if none did. Friction
  /// is implicit, so it is rounding, except energy stored in a compliance.
  double max_brake_power = 0;

  /// Dissipated by the brakes, without residual drag.
  double friction() const { return brakes + residual_friction; }
  /// Energy that is not accounted for; its bound is above.
  double imbalance() const { return kinetic - start - hand - gravity + brakes + residual_friction + drag; }
};

}  // namespace passive_haptics
