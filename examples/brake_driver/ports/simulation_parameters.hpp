/// @file
/// What the simulated device does not take from the calibration.
#pragma once

#include <passive_haptics/core/parameters.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace example {

namespace ph = passive_haptics;

/// What the simulated brakes are (passive_haptics/brake/models).
enum class brake_kind { coulomb, stribeck, magnetorheological, eddy_current };

/// A hand that goes along the first wall and presses on it, lifts off and goes back, again and again; and a
/// sensor with noise.
struct simulation_parameters {
  /// When the hand takes the handle, after the first sample and not before the sensor is tared [s].
  double hand_start = 2;
  std::vector<double> direction{1, 0};  ///< d, in which it goes first, base frame; any length.
  double path = 0.06;                   ///< How far it goes before it lifts off [m].
  double speed = 0.05;                  ///< Along the wall [m/s].
  double push = 2;                      ///< Into the wall [N]; a quarter of it off the wall on the way back.
  double hand_mass = 0.5;               ///< [kg]
  brake_kind brake = brake_kind::coulomb;  ///< Each with the limit and residual torque of its curve.
  double brake_lag = 0.020;                ///< Time constant of the simulated brakes [s].
  double sensor_noise = 0.02;              ///< Standard deviation of each force channel [N].
  std::uint64_t seed = 1;                  ///< Of that noise.
  double watchdog = 1;                     ///< Without currents for so long the simulated board lets go [s].
  std::string wire;  ///< A new file that shows what flows (simulated_wire.hpp); empty for none.

  /// The table of passive_haptics/core/parameters.hpp.
  static constexpr auto members() {
    using p = simulation_parameters;
    using ph::member, ph::range;
    return ph::member_table(
        member("hand_start", &p::hand_start, "s", range::not_negative),
        member("direction", &p::direction, "1", range::direction),
        member("path", &p::path, "m", range::positive), member("speed", &p::speed, "m/s", range::positive),
        member("push", &p::push, "N", range::not_negative),
        member("hand_mass", &p::hand_mass, "kg", range::positive),
        ph::choice("brake", &p::brake, "coulomb, stribeck, magnetorheological, eddy_current"),
        member("brake_lag", &p::brake_lag, "s", range::positive).suspicious_above(1),
        member("sensor_noise", &p::sensor_noise, "N", range::not_negative), member("seed", &p::seed),
        member("watchdog", &p::watchdog, "s", range::positive), member("wire", &p::wire));
  }
};
using ph::validate;

}  // namespace example
