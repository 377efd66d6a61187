/// @file
/// What the simulated device does not take from the calibration.
#pragma once

#include <passive_haptics/core/validate.hpp>

#include <array>
#include <cstdint>
#include <string>

namespace example {

/// A hand that goes along the first wall and presses on it, lifts off and goes back, again and again; and a
/// sensor with noise.
struct simulation_parameters {
  double hand_start = 2;                  ///< When the hand takes the handle, after the first sample [s].
  std::array<double, 2> direction{1, 0};  ///< In which it goes first, base frame; any length.
  double path = 0.06;                     ///< How far it goes before it lifts off [m].
  double speed = 0.05;                    ///< Along the wall [m/s].
  double push = 2;             ///< Into the wall [N]; a quarter of it off the wall on the way back.
  double hand_mass = 0.5;      ///< [kg]
  double brake_lag = 0.020;    ///< Time constant of the simulated brakes [s].
  double sensor_noise = 0.02;  ///< Standard deviation of each force channel [N].
  std::uint64_t seed = 1;      ///< Of that noise.
};

/// What is wrong with the parameters; empty if nothing.
inline std::string validate(const simulation_parameters& p) {
  namespace check = passive_haptics::detail;
  return check::first_error(
      check::check_not_negative("hand_start [s]", p.hand_start),
      check::check_finite("direction[0]", p.direction[0]),
      check::check_finite("direction[1]", p.direction[1]),
      p.direction[0] != 0 || p.direction[1] != 0 ? "" : std::string("direction = [0, 0], expected any other"),
      check::check_positive("path [m]", p.path), check::check_positive("speed [m/s]", p.speed),
      check::check_not_negative("push [N]", p.push), check::check_positive("hand_mass [kg]", p.hand_mass),
      check::check_positive("brake_lag [s]", p.brake_lag),
      check::check_not_negative("sensor_noise [N]", p.sensor_noise));
}

}  // namespace example
