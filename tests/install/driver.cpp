// A user's driver in small: three cycles of a loop.
#include <passive_haptics/driver/control_loop.hpp>
#include <passive_haptics/driver/safe_port.hpp>

namespace ph = passive_haptics;

int main() {
  ph::control_loop loop({.period = 1e-3});
  const auto report = loop.run([](const ph::loop_cycle& now) { return now.number < 3; }, [] { return false; },
                               [](ph::fault) {});
  return report.cycles > 0 && report.ended_by == ph::fault::none ? 0 : 1;
}
