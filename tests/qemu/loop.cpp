// The whole loop at 1 kHz: samples in, currents out, a supervisor beside it.
#include "guest.hpp"
#include "system_call_filter.hpp"

#include <passive_haptics/driver/control_loop.hpp>
#include <passive_haptics/driver/process/supervisor.hpp>
#include <passive_haptics/driver/real_time.hpp>
#include <passive_haptics/driver/safe_port.hpp>

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <numbers>

namespace guest {
namespace {

// A program with all parts; each cycle reads back what the one before wrote.
class program {
 public:
  // Empty if all is there and granted.
  std::string start() {
    if (auto text = watch_.start(); !text.empty()) return text;
    if (auto text = device_.open(); !text.empty()) return text;
    const ph::real_time quick({.priority = 80, .lock_memory = true});
    for (const auto& setting : quick.settings())
      if (!setting.refused.empty()) return setting.what + ": " + setting.refused;
    return {};
  }

  ph::loop_report run(std::int64_t cycles) {
    const auto cycle = [&](const ph::loop_cycle& c) {
      device_.read(c.time);
      supervised = watch_.beat(c.time, device_.applied()) && supervised;
      if (c.number == 1) device_.activate();
      else worst = std::max(worst, std::abs(device_.force()[0] - expected_));
      const double current = 2 - 2 * std::cos(2 * std::numbers::pi * c.time);
      device_.write({current, current});
      expected_ = device_.applied()[0] / amperes_per_volt;
      return c.number < cycles && device_.state() != ph::port_state::released;
    };
    const auto release = [&](ph::fault why) {
      if (released.what == ph::fault::none) released = {why};
      device_.release({why});
    };
    return loop_.run(cycle, [] { return false; }, release);
  }

  bool supervised = true;
  double worst = 0;           // difference of what was read back [V]
  ph::fault_record released;  // the first

 private:
  using safe = ph::safe_port<port, sensor>;
  static safe::parameters limits() {
    safe::parameters p;
    p.currents.max_current = p.currents.continuous = {4, 4};
    return p;
  }

  ph::supervisor<port> watch_{port(port_parameters()), {.timeout = 0.010, .priority = 90}};
  safe device_{port(port_parameters()), sensor(sensor_parameters()), limits()};
  ph::control_loop<> loop_;
  double expected_ = 0;
};

outcome ten_seconds() {
  constexpr int cycles = 10'000;
  program p;
  if (const auto text = p.start(); !text.empty()) return wrong(text);
  const double start = ph::monotonic_seconds();
  const ph::loop_report report = p.run(cycles);
  const double duration = ph::monotonic_seconds() - start;

  const auto us = [](std::int64_t ns) { return text(1e-3 * static_cast<double>(ns), " us"); };
  const std::string figures =
      text(report.cycles, " cycles in ", duration, " s, ", report.overruns, " overruns, ", report.missed,
           " missed; woken ", us(report.late.maximum()), " late at most; a cycle takes ",
           us(report.compute.percentile(0.5)), ", at most ", us(report.compute.maximum()), "; read back ",
           1e3 * p.worst, " mV off at most");
  const bool good = report.cycles == cycles && report.overruns == 0 && report.missed == 0 && p.supervised &&
                    p.released.what == ph::fault::user && std::abs(duration - 10) < 1e-3 &&
                    p.worst < 1.001 * half_a_step;
  return good ? outcome{"", figures} : wrong(figures + "; " + to_string(p.released));
}

// The kernel ends a process at once that makes another call than those.
outcome few_system_calls() {
  const pid_t child = fork();
  if (child == 0) {
    program p;
    if (!p.start().empty() || !allow_only_sleep_and_ioctl()) _exit(2);
    const ph::loop_report report = p.run(1000);
    _exit(report.cycles == 1000 && p.released.what == ph::fault::user ? 0 : 1);
  }
  int status = 0;
  while (waitpid(child, &status, 0) != child) {
  }
  if (WIFSIGNALED(status)) return wrong(text("another call, or a crash: signal ", WTERMSIG(status)));
  return status == 0 ? outcome{"", "1000 cycles"} : wrong(text("exit status ", WEXITSTATUS(status)));
}

}  // namespace

std::vector<check> loop_checks() {
  return {{"the loop makes no system calls but to sleep and to the card", few_system_calls},
          {"1 kHz for 10 s without an overrun", ten_seconds}};
}

}  // namespace guest
