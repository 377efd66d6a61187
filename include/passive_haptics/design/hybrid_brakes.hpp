/// Brakes with motors on their axes, for design only: no law drives a motor.
#pragma once

#include <passive_haptics/brake/models/switchable_brakes.hpp>
#include <passive_haptics/force/torques/nearest_torque.hpp>

namespace passive_haptics {

/// The m brakes of a device, each with a motor on its axis: torques s_i t_i <= motor_limit_i instead of s_i
/// t_i <= 0 (3), in a box that contains 0.
///
/// Brake and motor torques are not added: the larger one counts. If they add up in your device, use their sum
/// as the torque_limit. Brakes convert to this type. Controllers do not accept it (docs/guide/design.md).
template <class T, int Brakes>
struct hybrid_brake_parameters {
  switchable_brake_parameters<T, Brakes> brakes;              ///< The brakes.
  vector<T, Brakes> motor_limit = vector<T, Brakes>::Zero();  ///< Maximum torque of each motor, >= 0 [N m].

  hybrid_brake_parameters() = default;  ///< Brakes of 1 N m, no motors.
  /// Brakes and motors.
  hybrid_brake_parameters(const switchable_brake_parameters<T, Brakes>& brakes_alone,
                          const vector<T, Brakes>& motors = vector<T, Brakes>::Zero())
      : brakes(brakes_alone), motor_limit(motors) {}

  /// Brakes without motors.
  hybrid_brake_parameters(const brake_parameters<T, Brakes>& brakes_alone) : brakes(brakes_alone) {}

  /// Brakes with these torque limits [N m], without motors.
  static hybrid_brake_parameters with_limits(const vector<T, Brakes>& torque_limit) {
    hybrid_brake_parameters limited;
    limited.brakes.torque_limit = torque_limit;
    return limited;
  }

  /// True if some motor has a torque.
  bool has_motors() const { return (motor_limit.array() > T(0)).any(); }
  /// True if limits and intervals are valid: no NaN, each on its side of 0.
  bool is_valid() const {
    return (brakes.torque_limit.array() >= T(0)).all() && (brakes.torque_lower.array() <= T(0)).all() &&
           (brakes.torque_upper.array() >= T(0)).all() && (motor_limit.array() >= T(0)).all();
  }
};

/// The brakes of mechanism M with motors.
template <class M>
using hybrid_brakes = hybrid_brake_parameters<typename M::scalar, M::brake_count>;

/// The box of torques that these brakes and motors can produce with signs s.
template <class T, int Brakes>
torque_box<T, Brakes> torque_box_of(const vector<T, Brakes>& s,
                                    const hybrid_brake_parameters<T, Brakes>& hybrid) {
  const torque_box<T, Brakes> passive = passive_haptics::torque_box_of(s, hybrid.brakes);
  return {passive.lower.cwiseMin(-hybrid.motor_limit), passive.upper.cwiseMax(hybrid.motor_limit)};
}

}  // namespace passive_haptics
