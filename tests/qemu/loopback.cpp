// Currents go out as volts and come back through analog inputs.
#include "guest.hpp"

#include <algorithm>

namespace guest {
namespace {

outcome reads_back() {
  port outputs(port_parameters());
  sensor inputs(sensor_parameters());
  if (const auto text = outputs.open() + inputs.open(); !text.empty()) return wrong(text);
  double worst = 0;
  for (int i = 0; i <= 4000; ++i) {
    const std::array<double, 2> currents{1e-3 * i, 4 - 1e-3 * i};
    if (outputs.write(currents) != ph::port_status::ok)
      return wrong(text("write of ", currents[0], " A failed"));
    const auto volts = voltages(inputs);
    for (std::size_t k = 0; k < 2; ++k)
      worst = std::max(worst, std::abs(volts[k] - currents[k] / amperes_per_volt));
    if (!(worst < 1.001 * half_a_step)) return wrong(text(currents[0], " A became ", volts[0], " V"));
  }
  return {"", text("4001 currents on two channels, ", 1e3 * worst, " mV off at most")};
}

outcome zero_is_zero() {
  port outputs(port_parameters());
  sensor inputs(sensor_parameters());
  if (const auto text = outputs.open() + inputs.open(); !text.empty()) return wrong(text);
  outputs.write({1, 1});
  const auto before = voltages(inputs);
  outputs.write({0, 0});
  const auto written = voltages(inputs);
  outputs.write({1, 1});
  outputs.release();
  const auto released = voltages(inputs);
  if (!near(before, 2) || !near(written, 0) || written != released)
    return wrong(text("1 A: ", before[0], " V, 0 A: ", written[0], " V, released: ", released[0], " V"));
  return {"", text(1e3 * written[0], " mV, half a step")};
}

outcome end_of_range() {
  port outputs(port_parameters());
  sensor inputs(sensor_parameters());
  if (const auto text = outputs.open() + inputs.open(); !text.empty()) return wrong(text);
  outputs.write({100, 1});
  ph::port_sample<2> sample;
  if (inputs.read(sample) != ph::port_status::ok) return wrong("no sample");
  if (sample.value[0] != 10 || sample.valid[0] || !sample.valid[1])
    return wrong(text(sample.value[0], " V, valid: ", sample.valid[0], sample.valid[1]));
  return {};
}

outcome destructor() {
  sensor inputs(sensor_parameters());
  if (const auto text = inputs.open(); !text.empty()) return wrong(text);
  {
    port outputs(port_parameters());
    if (const auto text = outputs.open(); !text.empty()) return wrong(text);
    outputs.write({1, 1});
    if (!near(voltages(inputs), 2)) return wrong("1 A is not 2 V");
  }
  return near(voltages(inputs), 0) ? outcome{} : wrong(text(voltages(inputs)[0], " V"));
}

}  // namespace

std::vector<check> loopback_checks() {
  return {{"analog out is read back through analog in", reads_back},
          {"0 A and a release are 0 V", zero_is_zero},
          {"a current beyond the range is clamped, and an input at its end not valid", end_of_range},
          {"a port that ends leaves 0 V", destructor}};
}

}  // namespace guest
