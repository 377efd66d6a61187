/// @file
/// Where the energy of a simulated device came from and where it went.
#pragma once

namespace passive_haptics {

/// Energies of a simulated device since its motion was last set [J]. Sums in double, whatever the device's
/// scalar.
///
/// A step with impulses P changes the rates from qd to qd', and P . (qd + qd')/2 is the change of kinetic
/// energy exactly while the mass matrix stays. So all works are taken at the mid-point rate, and what does
/// not balance is
///
///     qd' . (M(q') - M(q)) qd' / 2  -  dt (c - g) . (qd + qd')/2      in a step,
///
/// whose parts cancel to O(dt^2 |qd| P') with P' the power of all forces, Coriolis forces included. Over a
/// run
///
///     |imbalance| <= k dt sum |qd| (|work| + dt |qd| kinetic),
///
/// with k of order 1 per radian (the mass matrix of a linkage changes by its own size in a radian); tests
/// hold k = 1 for tendon_two_link, five_bar, delta and a serial chain. It is O(dt): halving dt halves it. It
/// is rounding where M is constant.
struct energy_balance {
  double start = 0;    ///< Kinetic energy of device and hand when its motion was set.
  double hand = 0;     ///< Work of the hand's muscles, in.
  double gravity = 0;  ///< Work of gravity, in.
  /// Dissipated by what was commanded of the brakes, or stored by their compliance.
  double brakes = 0;
  double residual_friction = 0;  ///< Dissipated by the brakes' residual friction.
  double drag = 0;               ///< Dissipated by the brakes' residual drag.
  double kinetic = 0;            ///< Kinetic energy of device and hand now.
  /// Largest power that one brake's friction gave to the device in one step [W], t_i w_i with the rates at
  /// the end of the step; 0 if none ever gave any. Friction is implicit, so it is 0 to rounding: at most
  /// rounding_tolerance(m) torque_i (|w_i| + A |torque| dt), see solve_box_friction. A brake with compliance
  /// gives back what its spring took.
  double max_brake_power = 0;

  /// Dissipated by the brakes, all but their residual drag.
  double friction() const { return brakes + residual_friction; }
  /// Energy that nothing accounts for; see above how small it is.
  double imbalance() const { return kinetic - start - hand - gravity + brakes + residual_friction + drag; }
};

}  // namespace passive_haptics
