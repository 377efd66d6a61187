// What the outputs do when their program is killed or stopped, alone and with a supervisor.
#include "guest.hpp"

#include <passive_haptics/driver/process/supervisor.hpp>

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

namespace guest {
namespace {

constexpr double holding = 2;       // [V]
constexpr double promised = 0.020;  // [s]

// A program that holds 2 V at 1 kHz, from fork() on.
pid_t start_program(bool supervised) {
  const pid_t program = fork();
  if (program != 0) return program;
  ph::supervisor watch{port(port_parameters())};
  if (supervised && !watch.start().empty()) _exit(1);
  port outputs(port_parameters());
  if (!outputs.open().empty()) _exit(1);
  const ph::monotonic_clock clock;
  double current = 0;
  for (std::int64_t wake = clock.now();; wake += 1'000'000) {
    clock.sleep_until(wake);
    const bool well = !supervised || watch.beat(ph::monotonic_seconds(), {current, current});
    current = well ? amperes_per_volt * holding : 0;
    outputs.write({current, current});
  }
}

outcome keeps_its_voltage() {
  sensor inputs(sensor_parameters());
  if (const auto text = inputs.open(); !text.empty()) return wrong(text);
  const pid_t program = start_program(false);
  const bool held = time_until([&] { return near(voltages(inputs), holding); }, 1) >= 0;
  kill(program, SIGKILL);
  waitpid(program, nullptr, 0);
  sleep_for(5);
  const auto volts = voltages(inputs);
  port(port_parameters()).open();  // 0 V for those that follow
  if (!held || !near(volts, holding)) return wrong(text(volts[0], " V"));
  return {"", text(volts[0], " V, 5 s after SIGKILL")};
}

// The longest time from this signal to 0 V.
template <int Signal>
outcome supervised() {
  sensor inputs(sensor_parameters());
  if (const auto text = inputs.open(); !text.empty()) return wrong(text);
  constexpr int tries = 20;
  double worst = 0;
  for (int i = 0; i < tries; ++i) {
    const pid_t program = start_program(true);
    const bool held = time_until([&] { return near(voltages(inputs), holding); }, 1) >= 0;
    sleep_for(0.0500 + 0.00037 * i);  // in the midst of its cycles, at another place each time
    const bool still = near(voltages(inputs), holding);
    kill(program, Signal);
    const double time = time_until([&] { return near(voltages(inputs), 0); }, 1);
    sleep_for(0.05);
    const bool stays = near(voltages(inputs), 0);
    kill(program, SIGKILL);
    while (waitpid(-1, nullptr, 0) > 0) {  // the supervisor, too, is ours now
    }
    if (!held || !still) return wrong("the program did not hold 2 V");
    if (!(time <= promised)) return wrong(text("0 V after ", 1e3 * time, " ms"));
    if (!stays) return wrong("0 V did not stay");
    worst = std::max(worst, time);
  }
  return {"", text(tries, " times, 0 V after ", 1e3 * worst, " ms at most")};
}

}  // namespace

std::vector<check> killed_program_checks() {
  return {{"an output keeps its voltage when its program is killed", keeps_its_voltage},
          {"a supervisor puts 0 V within 20 ms of SIGKILL", supervised<SIGKILL>},
          {"a supervisor puts 0 V within 20 ms of SIGSEGV", supervised<SIGSEGV>},
          {"a supervisor puts 0 V within 20 ms of SIGSTOP", supervised<SIGSTOP>}};
}

}  // namespace guest
