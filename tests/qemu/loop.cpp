// The whole loop at 1 kHz: samples in, currents out, a supervisor beside it.
#include "guest.hpp"

#include <passive_haptics/driver/control_loop.hpp>
#include <passive_haptics/driver/real_time.hpp>
#include <passive_haptics/driver/safe_port.hpp>
#include <passive_haptics/driver/supervisor.hpp>

#include <algorithm>
#include <numbers>

namespace guest {
namespace {

outcome ten_seconds() {
  constexpr std::uint64_t cycles = 10'000;
  ph::supervisor watch(port(port_parameters()), {.timeout = 0.010, .priority = 90});
  if (const auto text = watch.start(); !text.empty()) return wrong(text);
  ph::safe_port<port, sensor>::parameters limits;
  limits.currents.largest = limits.currents.continuous = {4, 4};
  ph::safe_port<port, sensor> device(port(port_parameters()), sensor(sensor_parameters()), limits);
  if (const auto text = device.open(); !text.empty()) return wrong(text);
  const ph::real_time quick({.priority = 80, .lock_memory = true});
  for (const auto& setting : quick.settings())
    if (!setting.refused.empty()) return wrong(setting.what + ": " + setting.refused);

  // Each cycle reads back what the one before wrote
  double worst = 0, expected = 0;
  bool supervised = true;
  const auto cycle = [&](const ph::loop_cycle& c) {
    device.read(c.time);
    supervised = supervised && watch.beat(c.time);
    if (c.number == 1) device.activate();
    else worst = std::max(worst, std::abs(device.force()[0] - expected));
    const double current = 2 - 2 * std::cos(2 * std::numbers::pi * c.time);
    device.write({current, current});
    expected = device.applied()[0] / amperes_per_volt;
    return c.number < static_cast<std::int64_t>(cycles) && device.state() != ph::port_state::released;
  };
  std::string released;
  const auto release = [&](ph::fault why) {
    if (why != ph::fault::user) released += std::string(to_string(why)) + "; ";
    device.release({why});
  };
  const double start = ph::monotonic_seconds();
  const ph::loop_report report = ph::control_loop().run(cycle, [] { return false; }, release);
  const double duration = ph::monotonic_seconds() - start;

  const std::string figures =
      text(report.cycles, " cycles in ", duration, " s, ", report.overruns, " overruns, ", report.missed,
           " missed, woken ", 1e-3 * static_cast<double>(report.late.largest()),
           " us late at most, computed for ", 1e-3 * static_cast<double>(report.compute.percentile(0.5)),
           " us, at most ", 1e-3 * static_cast<double>(report.compute.largest()), " us, read back ",
           1e3 * worst, " mV off at most");
  const bool good = report.cycles == cycles && report.overruns == 0 && report.missed == 0 &&
                    released.empty() && supervised && std::abs(duration - 10) < 1e-3 &&
                    worst < 1.001 * half_a_step;
  return good ? outcome{"", figures} : wrong(figures + "; " + released + to_string(device.reason()));
}

}  // namespace

std::vector<check> loop_checks() { return {{"1 kHz for 10 s without an overrun", ten_seconds}}; }

}  // namespace guest
