/// @file
/// What a session needs of a device: any mechanism under any law.
#pragma once

#include <configuration/configuration.hpp>
#include <configuration/home.hpp>
#include <ports/any_port.hpp>
#include <report/record.hpp>

#include <array>
#include <memory>
#include <string>

namespace example {

/// The last good samples of encoders and force sensor.
struct samples {
  double now = 0;   ///< [s], since the loop began.
  double time = 0;  ///< When the encoders were read [s].
  std::array<double, axes> counts{};
  std::array<double, sensor_channels> readings{};
};

/// A mechanism with its calibration, walls and law.
class haptic_device {
 public:
  virtual ~haptic_device() = default;

  /// Port and sensor of its simulation.
  virtual any_brake_port<axes, axes> simulated_port() = 0;
  virtual any_force_sensor simulated_sensor() = 0;

  /// One more cycle at rest, of homing, then of taring; what is to be done next.
  virtual phase prepare(const samples& now) noexcept = 0;
  /// What kept homing or taring from its end so far, in words.
  virtual std::string hindrance() const = 0;
  /// The wall in which the handle is deepest now; once it is homed.
  virtual wall_depth deepest_wall(const samples& now) const noexcept = 0;
  /// One cycle with walls, or without where it is not `running` yet: currents [A], and what is to be written
  /// down.
  virtual ph::brake_currents<axes> cycle(const samples& now, phase doing, record& r) noexcept = 0;
  /// Forgets the motion so far.
  virtual void reset() noexcept = 0;
};

/// The device of a configuration. Throws std::invalid_argument with what is wrong.
std::unique_ptr<haptic_device> make_device(const configuration& c);

/// Those of each mechanism, in files of their own.
std::unique_ptr<haptic_device> make_tendon_two_link(const configuration& c);
std::unique_ptr<haptic_device> make_xy_table(const configuration& c);
std::unique_ptr<haptic_device> make_five_bar(const configuration& c);

}  // namespace example
