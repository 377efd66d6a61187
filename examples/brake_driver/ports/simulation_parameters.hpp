/// Parameters of the simulated device that are not in the calibration.
#pragma once

#include <passive_haptics/core/parameters.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace example {

namespace ph = passive_haptics;

/// A hand that repeatedly moves along the first wall with a push, lifts off and returns; and a sensor with
/// noise.
struct simulation_parameters {
  /// Time at which the hand takes the handle, after the first sample and taring [s].
  double hand_start = 2;
  std::vector<double> direction{1, 0};  ///< d, first direction, base frame; any length.
  double path = 0.06;                   ///< Distance before it lifts off [m].
  double speed = 0.05;                  ///< Along the wall [m/s].
  double push = 2;         ///< Into the wall [N]; a quarter of it away from the wall on the way back.
  double hand_mass = 0.5;  ///< [kg]
  /// Time constant of the brakes [s]; limit and residual torque are those of their curves.
  double brake_lag = 0.020;
  double sensor_noise = 0.02;  ///< Standard deviation of each force channel [N].
  std::uint64_t seed = 1;      ///< Of that noise.
  double watchdog = 1;  ///< Time without currents after which the simulated board releases the brakes [s].
  std::string wire;     ///< A new file with the applied currents (simulated_wire.hpp); empty for none.

  static constexpr auto members() {
    using p = simulation_parameters;
    using ph::member, ph::range;
    return ph::member_table(
        member("hand_start", &p::hand_start, "s", range::not_negative),
        member("direction", &p::direction, "1", range::direction),
        member("path", &p::path, "m", range::positive), member("speed", &p::speed, "m/s", range::positive),
        member("push", &p::push, "N", range::not_negative),
        member("hand_mass", &p::hand_mass, "kg", range::positive),
        member("brake_lag", &p::brake_lag, "s", range::positive).suspicious_above(1),
        member("sensor_noise", &p::sensor_noise, "N", range::not_negative), member("seed", &p::seed),
        member("watchdog", &p::watchdog, "s", range::positive), member("wire", &p::wire));
  }
};
using ph::validate;

}  // namespace example
