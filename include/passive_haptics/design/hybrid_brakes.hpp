/// @file
/// Brakes with a motor beside each, for questions of design alone: no law drives a motor.
#pragma once

#include <passive_haptics/brake/models/switchable_brakes.hpp>
#include <passive_haptics/force/torques/nearest_torque.hpp>

namespace passive_haptics {

/// The m brakes of a device, each with a motor on its axis: torques s_i t_i <= motor_limit_i in place of
/// s_i t_i <= 0 (3), in a box that contains 0.
///
/// Brake and motor are not added: what resists is the larger of the two. If they add up in your device, give
/// their sum as the torque_limit. The interval of a brake that is off or works one way is not that of its
/// motor. Brakes alone convert to this type, with motors of 0 N m. A controller does not take it
/// (docs/guide/hybrid.md).
template <class T, int Brakes>
struct hybrid_brake_parameters {
  switchable_brake_parameters<T, Brakes> brakes;              ///< The brakes.
  vector<T, Brakes> motor_limit = vector<T, Brakes>::Zero();  ///< Most torque of each motor, >= 0 [N m].

  /// Brakes of 1 N m, no motors.
  hybrid_brake_parameters() = default;
  /// These brakes and these motors.
  hybrid_brake_parameters(const switchable_brake_parameters<T, Brakes>& brakes_alone,
                          const vector<T, Brakes>& motors = vector<T, Brakes>::Zero())
      : brakes(brakes_alone), motor_limit(motors) {}

  /// These brakes, no motors.
  hybrid_brake_parameters(const brake_parameters<T, Brakes>& brakes_alone) : brakes(brakes_alone) {}

  /// Whether some motor makes a torque.
  bool has_motors() const { return (motor_limit.array() > T(0)).any(); }
  /// Whether limits and intervals are those of brakes and motors: no NaN, each on its side of 0.
  bool is_valid() const {
    return (brakes.torque_limit.array() >= T(0)).all() && (brakes.torque_lower.array() <= T(0)).all() &&
           (brakes.torque_upper.array() >= T(0)).all() && (motor_limit.array() >= T(0)).all();
  }
};

/// The brakes of mechanism M, each with a motor.
template <class M>
using hybrid_brakes = hybrid_brake_parameters<typename M::scalar, M::brake_count>;

/// The box of torques that these brakes and motors can make with signs s: those of the brakes and of the
/// motors, and all between.
template <class T, int Brakes>
torque_box<T, Brakes> torque_box_of(const vector<T, Brakes>& s,
                                    const hybrid_brake_parameters<T, Brakes>& hybrid) {
  const torque_box<T, Brakes> passive = passive_haptics::torque_box_of(s, hybrid.brakes);
  return {passive.lower.cwiseMin(-hybrid.motor_limit), passive.upper.cwiseMax(hybrid.motor_limit)};
}

}  // namespace passive_haptics
