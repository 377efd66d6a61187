/// @file
/// What a session needs of a device: any mechanism under any law.
#pragma once

#include <configuration/configuration.hpp>
#include <configuration/home.hpp>
#include <ports/any_port.hpp>
#include <ports/simulation.hpp>
#include <report/record.hpp>

#include <array>
#include <memory>
#include <string>

namespace example {

/// The last good samples of encoders and force sensor.
struct samples {
  double now = 0;   ///< [s], since the loop began.
  double time = 0;  ///< When the encoders were read [s].
  std::array<double, max_axes> counts{};
  std::array<double, sensor_channels> readings{};
};

/// A mechanism with its calibration, walls and law.
class haptic_device {
 public:
  /// The device of a configuration. Throws std::invalid_argument with what is wrong.
  explicit haptic_device(const configuration& c);

  /// Port and sensor of its simulation.
  any_brake_port simulated_port();
  any_force_sensor simulated_sensor();

  /// One more cycle at rest, of homing, then of taring; what is to be done next.
  phase prepare(const samples& now) noexcept;
  /// What kept homing or taring from its end so far, in words.
  std::string hindrance() const;
  /// The wall in which the handle is deepest now; once it is homed.
  wall_depth deepest_wall(const samples& now) const noexcept;
  /// A record without a motion and a decision.
  record blank_record() const noexcept { return record(configuration_.mechanism.sizes()); }
  /// One cycle with walls, or without where it is not `running` yet: currents [A], and what is to be written
  /// down, in a blank record.
  ph::brake_currents<max_axes> cycle(const samples& now, phase doing, record& r) noexcept;
  /// Forgets the motion so far.
  void reset() noexcept { control_->reset(); }

 private:
  // Remembers what began it anew
  bool is_done(ph::steady_status now) noexcept {
    if (now != ph::steady_status::collecting) hindered_ = now;
    return now == ph::steady_status::done;
  }

  configuration configuration_;
  calibration calibration_;
  std::unique_ptr<ph::runtime::any_controller> control_;
  ph::homing<max_axes> homing_;
  ph::steady_mean<sensor_channels> tare_;
  ph::steady_status hindered_ = ph::steady_status::collecting;  // the last that was not this
  phase doing_ = phase::homing;
  std::shared_ptr<simulation> plant_;
};

}  // namespace example
