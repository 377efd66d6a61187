// A device whose every answer a test decides, and a safe port to it.
#pragma once

#include <passive_haptics/driver/safe_port.hpp>

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

namespace fake {

namespace ph = passive_haptics;

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

using safe = ph::safe_port<port, sensor>;
using status = ph::port_status;
using currents = ph::brake_currents<2>;

inline safe::parameters usual() {
  safe::parameters p;
  p.encoders.frozen_travel = 2048;
  p.sensor.range.fill(100);
  p.currents.max_current.fill(1);
  p.currents.continuous.fill(0.9);
  p.currents.heat.fill(0.05);
  return p;
}
inline safe::parameters released_by(const ph::release_parameters& at_release) {
  auto p = usual();
  p.at_release = at_release;
  return p;
}
inline constexpr ph::release_parameters ramp{.policy = ph::release_policy::ramp, .ramp_time = 0.1},
    hold{.policy = ph::release_policy::hold}, hold_half_a_second{.policy = hold.policy, .hold_time = 0.5};

// A device that moves slowly and is cycled at 1 kHz.
struct rig {
  explicit rig(const safe::parameters& p = usual(), int counter_bits = 0) : port({&device}, {&device}, p) {
    device.counter_bits = counter_bits;
    if (!port.open().empty()) throw std::runtime_error("the fake device is there");
  }
  explicit rig(const ph::release_parameters& at_release) : rig(released_by(at_release)) {}

  // What a good device tells next.
  void take_samples() {
    time += 1e-3;
    sample.time = force.time = time;
    ++sample.sequence;
    ++force.sequence;
    for (double& count : sample.value) count += 3;
    force.value[0] = 1 + 0.1 * time;
  }
  void transfer() {
    port.read(time);
    port.write(wanted);
  }
  void cycle() {
    take_samples();
    transfer();
  }
  // One cycle; `spoil` changes what the device tells, not what it does.
  void cycle(const std::function<void(rig&)>& spoil) {
    const auto counts = sample.value;
    const auto forces = force.value;
    take_samples();
    spoil(*this);
    transfer();
    sample.value = {counts[0] + 3, counts[1] + 3};
    force.value = forces;
    sample.valid = {true, true};
    force.valid = {true, true, true};
    device.read_status = device.sensor_status = device.write_status = ph::port_status::ok;
  }
  void cycles(int count) {
    for (int k = 0; k < count; ++k) cycle();
  }
  void activate() {
    cycle();
    ASSERT_TRUE(port.activate());
  }
  void hold() {
    activate();
    cycles(3);
    EXPECT_EQ(port.state(), ph::port_state::active);
    EXPECT_EQ(device.currents, wanted);
  }
  // Until nothing flows.
  int cycles_to_release(const std::function<void(rig&)>& spoil) {
    for (int k = 1; k <= 200; ++k) {
      cycle(spoil);
      if (!device.flows()) return k;
    }
    return 1000;
  }

  fake::device device;
  ph::port_sample<2>& sample = device.sample;
  ph::port_sample<3>& force = device.force;
  double time = 100;
  ph::brake_currents<2> wanted{0.5, 0.25};
  safe port;
};
inline void say_nothing(rig& r) { r.device.read_status = status::no_sample; }
inline void refuse(rig& r) { r.device.write_status = status::no_sample; }

}  // namespace fake
