/// The device of a session: any mechanism under any law.
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
  double now = 0;   ///< [s], since the start of the loop.
  double time = 0;  ///< Sampling time of the encoders [s].
  std::array<double, max_axes> counts{};
  std::array<double, sensor_channels> readings{};
};

/// A mechanism with its calibration, walls and law.
class haptic_device {
 public:
  /// The device of a configuration. Throws std::invalid_argument.
  explicit haptic_device(const configuration& c);

  /// Port of its simulation; the sensor below.
  any_brake_port simulated_port();
  any_force_sensor simulated_sensor();

  /// One more cycle of homing or taring at rest; returns the next phase.
  phase prepare(const samples& now) noexcept;
  /// Text of what has prevented homing or taring from finishing.
  std::string hindrance() const;
  /// The wall in which the handle is deepest; requires homing.
  wall_depth deepest_wall(const samples& now) const noexcept;
  /// A record without motion and decision.
  record blank_record() const noexcept { return record(configuration_.mechanism.sizes()); }
  /// One cycle with walls, or without before `running`: returns the currents [A] and fills a blank record.
  ph::brake_currents<max_axes> cycle(const samples& now, phase doing, record& r) noexcept;
  /// Forgets the motion so far.
  void reset() noexcept { control_->reset(); }

 private:
  // Stores the reason for a restart
  bool is_done(ph::steady_status now) noexcept {
    if (now != ph::steady_status::collecting) hindered_ = now;
    return now == ph::steady_status::done;
  }

  configuration configuration_;
  calibration calibration_;
  std::unique_ptr<ph::runtime::any_controller> control_;
  ph::homing<max_axes> homing_;
  ph::steady_mean<sensor_channels> tare_;
  ph::steady_status hindered_ = ph::steady_status::collecting;  // the last other status
  phase doing_ = phase::homing;
  std::shared_ptr<simulation> plant_;
};

}  // namespace example
