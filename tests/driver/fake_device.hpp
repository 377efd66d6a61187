// A device whose every answer a test decides.
#pragma once

#include <passive_haptics/driver/port.hpp>

#include <limits>
#include <string>

namespace fake {

namespace ph = passive_haptics;

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinite = std::numeric_limits<double>::infinity();

struct device {
  std::string encoders_missing, sensor_missing;  // what open() says
  ph::port_status read_status = ph::port_status::ok;
  ph::port_status sensor_status = ph::port_status::ok;
  ph::port_status write_status = ph::port_status::ok;
  ph::port_sample<2> sample{0, 0, {0, 0}, {true, true}};
  ph::port_sample<3> force{0, 0, {0, 0, 0}, {true, true, true}};

  ph::brake_currents<2> currents{};  // what flows now
  int writes = 0, releases = 0, counter_bits = 0;
  double watchdog = 0.02;  // [s]

  bool flows() const { return currents != ph::brake_currents<2>{}; }
};

struct port {
  static constexpr int encoder_count = 2, brake_count = 2;
  device* of;

  std::string open() { return of->encoders_missing; }
  ph::port_status read(ph::port_sample<2>& sample) noexcept {
    sample = of->sample;
    return of->read_status;
  }
  ph::port_status write(const ph::brake_currents<2>& currents) noexcept {
    ++of->writes;
    if (of->write_status == ph::port_status::ok) of->currents = currents;
    return of->write_status;
  }
  int counter_bits() const noexcept { return of->counter_bits; }
  double watchdog() const noexcept { return of->watchdog; }
  void release() noexcept {
    ++of->releases;
    of->currents = {};
  }
};

struct sensor {
  static constexpr int channel_count = 3;
  device* of;

  std::string open() { return of->sensor_missing; }
  ph::port_status read(ph::port_sample<3>& sample) noexcept {
    sample = of->force;
    return of->sensor_status;
  }
};

static_assert(ph::BrakePort<port> && ph::ForceSensor<sensor>);

}  // namespace fake
