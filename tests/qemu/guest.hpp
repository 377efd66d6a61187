// What the checks in the guest share. The guest has no test library: it is a static program, alone in an
// initramfs.
#pragma once

#include <comedi/comedi_force_sensor.hpp>
#include <comedi/comedi_port.hpp>
#include <passive_haptics/driver/clock.hpp>

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace guest {

namespace ph = passive_haptics;

// The kernel's comedi_test: subdevice 0 is an analog input that echoes the analog output 1 channel by
// channel; no counters.
constexpr const char* self_configured = "/dev/comedi1";
constexpr const char* configured_by_hand = "/dev/comedi0";  // without a driver until attach()
constexpr double half_a_step = 0.5 * 20 / 65535;            // [V], of -10 to 10 V in 16 bits
constexpr double amperes_per_volt = 0.5;

using port = example::comedi_port<0, 2>;
using sensor = example::comedi_force_sensor<2>;

inline port::parameters port_parameters(const std::string& device = self_configured) {
  port::parameters p;
  p.device = device;
  p.brakes[0] = {.channel = 2, .amperes_per_volt = amperes_per_volt, .max_current = 4};
  p.brakes[1] = {.channel = 5, .amperes_per_volt = amperes_per_volt, .max_current = 4};
  return p;
}

inline sensor::parameters sensor_parameters(const std::string& device = self_configured) {
  sensor::parameters p;
  p.device = device;
  p.channels = {2, 5};
  return p;
}

// What a check found: nothing, or what is wrong; and figures for a person.
struct outcome {
  std::string error, figures;
};

template <class... Parts>
std::string text(const Parts&... parts) {
  std::ostringstream all;
  (all << ... << parts);
  return all.str();
}

inline outcome wrong(const std::string& error) { return {error.empty() ? "unknown" : error, ""}; }

// Both channels [V]; NaN where they cannot be read.
inline std::array<double, 2> voltages(sensor& inputs) {
  ph::port_sample<2> sample;
  if (inputs.read(sample) != ph::port_status::ok) return {NAN, NAN};
  return sample.value;
}

inline bool near(const std::array<double, 2>& volts, double expected) {
  return std::abs(volts[0] - expected) < 1.001 * half_a_step &&
         std::abs(volts[1] - expected) < 1.001 * half_a_step;
}

inline void sleep_for(double seconds) {
  const ph::monotonic_clock clock;
  clock.sleep_until(clock.now() + std::llround(1e9 * seconds));
}

// Waits for a condition, looking at it every 0.1 ms: how long it took [s], or NaN if longer than `at_most`.
template <class Condition>
double time_until(Condition&& condition, double at_most) {
  const double start = ph::monotonic_seconds();
  for (;;) {
    if (condition()) return ph::monotonic_seconds() - start;
    if (ph::monotonic_seconds() - start > at_most) return NAN;
    sleep_for(1e-4);
  }
}

struct check {
  const char* name;  // as in expected.txt
  outcome (*run)();
};
std::vector<check> loopback_checks(), opening_checks(), lost_device_checks(), killed_program_checks(),
    loop_checks();

}  // namespace guest
