// The time from each hazard to 0 A, as hazards() states it, measured on a device in memory.
// A loop and its supervisor run as processes of their own; this one brings about the hazard and reads when
// the current of the device ended.
#include <passive_haptics/driver/control_loop.hpp>
#include <passive_haptics/driver/hazards.hpp>
#include <passive_haptics/driver/process/shared_memory.hpp>
#include <passive_haptics/driver/process/supervisor.hpp>
#include <passive_haptics/driver/safe_port.hpp>
#include <passive_haptics/driver/stop_signals.hpp>
#include <passive_haptics/driver/thread/threaded_port.hpp>

#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace {

namespace ph = passive_haptics;

enum class trouble {
  none,
  count_not_a_number,
  count_that_jumps,
  every_second_count_jumps,
  encoder_invalid,
  no_sample,
  sample_repeated,
  sample_late,
  write_rejected,
  all_rejected,
  sensor_silent,
  sensor_lost,
  device_lost,
  device_restarted,
  command_not_a_number,
  command_negative,
  suspend,
  cycles_of_1_5_periods,
  cycles_of_50_ms,
  law_throws,
  cycle_hangs,
  transfer_hangs,
};

struct row {
  std::string_view hazard;  // as it begins in hazards()
  const char* how;
  trouble what = trouble::none;
  int signal = 0;
  bool to_supervisor = false, threaded = false;
  bool at_most = false;  // may be found sooner: the stated time is that of the worst case
};

constexpr row rows[] = {
    {"An encoder's count", "NaN", trouble::count_not_a_number},
    {"An encoder's count", "1e6 counts off", trouble::count_that_jumps},
    {"An encoder's count", "invalid", trouble::encoder_invalid},
    {"Of the encoders' samples", "every second 1000 off", trouble::every_second_count_jumps, 0, false, false,
     true},
    {"No sample", "none", trouble::no_sample},
    {"No sample", "repeated", trouble::sample_repeated},
    {"No sample", "30 ms old", trouble::sample_late},
    {"The device rejects currents", "and accepts the release", trouble::write_rejected},
    {"The device rejects currents and the release", "", trouble::all_rejected},
    {"The force sensor is silent", "", trouble::sensor_silent},
    {"The device is lost", "read fails", trouble::device_lost},
    {"The device is lost", "restarted", trouble::device_restarted},
    {"The force sensor is lost", "", trouble::sensor_lost},
    {"A command is NaN", "NaN", trouble::command_not_a_number},
    {"A command is NaN", "-1", trouble::command_negative},
    {"The machine goes on after a suspend", "by the loop's clock", trouble::suspend},
    {"More than `max_overruns` cycles", "1.5 ms each", trouble::cycles_of_1_5_periods, 0, false, false, true},
    {"More than `max_overruns` cycles", "50 ms each", trouble::cycles_of_50_ms, 0, false, false, true},
    {"The law throws", "", trouble::law_throws},
    {"SIGINT", "SIGINT", trouble::none, SIGINT},
    {"The loop's process dies", "SIGKILL", trouble::none, SIGKILL},
    {"The loop's process dies", "SIGKILL, threaded port", trouble::none, SIGKILL, false, true},
    {"The loop's process dies", "SIGUSR2", trouble::none, SIGUSR2},
    {"The loop is stopped (SIGSTOP)", "SIGSTOP", trouble::none, SIGSTOP},
    {"The loop is stopped (SIGSTOP)", "SIGSTOP, threaded port", trouble::none, SIGSTOP, false, true},
    {"The loop is stopped (SIGSTOP)", "a cycle hangs", trouble::cycle_hangs},
    {"A transfer of a threaded port", "", trouble::transfer_hangs, 0, false, true, true},
    {"The supervisor dies", "SIGKILL", trouble::none, SIGKILL, true},
    {"The supervisor dies", "SIGSTOP", trouble::none, SIGSTOP, true},
};

// Shared by the processes: the wire to the brakes, and the fault to bring about.
struct device {
  std::atomic<double> current = 0;        // [A]
  std::atomic<double> ended = 0;          // when it last came to 0 A [s]
  std::atomic<std::uint32_t> writes = 0;  // of the loop
  std::atomic<trouble> what = trouble::none;
  std::atomic<pid_t> supervisor = 0;

  void give(double amperes) noexcept {
    if (current.exchange(amperes) != 0 && amperes == 0) ended = ph::monotonic_seconds();
  }
};

struct memory_port {
  static constexpr int encoder_count = 2, brake_count = 2;
  device* of;
  bool supervises = false;
  std::uint32_t sequence = 0;

  std::string open() { return {}; }
  ph::port_status read(ph::port_sample<2>& sample) noexcept {
    while (of->what == trouble::transfer_hangs) usleep(1000);
    const trouble what = of->what;
    if (what == trouble::device_lost) return ph::port_status::failed;
    if (what == trouble::no_sample) return ph::port_status::no_sample;
    sequence += what == trouble::sample_repeated ? 0 : what == trouble::device_restarted ? 5000 : 1;
    sample = {ph::monotonic_seconds(), sequence, {100 + 0.01 * sequence, 100}, {true, true}};
    if (what == trouble::sample_late) sample.time -= 0.03;
    if (what == trouble::count_not_a_number) sample.value[1] = std::numeric_limits<double>::quiet_NaN();
    if (what == trouble::count_that_jumps) sample.value[1] = 1e6;
    if (what == trouble::every_second_count_jumps) sample.value[1] += sequence % 2 * 1000.0;
    if (what == trouble::encoder_invalid) sample.valid[0] = false;
    return ph::port_status::ok;
  }
  // A device that rejects a value keeps what flows. The supervisor has a way of its own to it
  bool rejects(trouble least) const noexcept {
    return !supervises && (of->what == trouble::all_rejected || of->what == least);
  }
  ph::port_status write(const ph::brake_currents<2>& currents) noexcept {
    if (!supervises) ++of->writes;
    if (rejects(trouble::write_rejected)) return ph::port_status::no_sample;
    of->give(std::max(currents[0], currents[1]));
    return ph::port_status::ok;
  }
  void release() noexcept {
    if (!rejects(trouble::all_rejected)) of->give(0);
  }
};

struct memory_sensor {
  static constexpr int channel_count = 1;
  device* of;
  std::uint32_t sequence = 0;

  std::string open() { return {}; }
  ph::port_status read(ph::port_sample<1>& sample) noexcept {
    if (of->what == trouble::sensor_lost) return ph::port_status::failed;
    if (of->what == trouble::sensor_silent) return ph::port_status::no_sample;
    sample = {ph::monotonic_seconds(), ++sequence, {0}, {true}};
    return ph::port_status::ok;
  }
};

struct clock_of_a_suspend : ph::monotonic_clock {
  device* of;
  std::int64_t boot_time() const noexcept {
    return now() + (of->what == trouble::suspend ? std::int64_t{3'600'000'000'000} : 0);
  }
};

// The loop's process.
template <class Port>
void drive(device& d, Port port_to_device) {
  // As much as a program with locked memory has, which the kernel frees before anybody hears of its end
  const std::vector<char> memory(8 << 20, 1);
  ph::supervisor<memory_port> guard({&d, true});
  if (!guard.start().empty()) _exit(1);
  d.supervisor = guard.pid();
  ph::safe_port<Port, memory_sensor> port(std::move(port_to_device), {&d});
  if (!port.open().empty()) _exit(1);
  const ph::stop_signals signals;
  ph::control_loop loop({}, clock_of_a_suspend{{}, &d});
  loop.run(
      [&](const ph::loop_cycle& now) {
        const trouble what = d.what;
        port.read(now.time);
        if (what == trouble::none) port.activate();
        if (what == trouble::law_throws) throw std::runtime_error("a law");
        if (what == trouble::cycles_of_1_5_periods) usleep(1500);
        if (what == trouble::cycles_of_50_ms) usleep(50'000);
        while (d.what == trouble::cycle_hangs) {
        }
        if (!guard.beat(now.time, port.applied())) port.release({ph::fault::supervisor_lost}, guard.began());
        const double wanted = what == trouble::command_not_a_number ? std::numeric_limits<double>::quiet_NaN()
                              : what == trouble::command_negative   ? -1
                                                                    : 0.8;
        port.write({wanted, 0.5});
        return true;
      },
      [&] { return signals.stop() != 0; }, [&](ph::fault why) { port.release({why}); });
}

// The number of times a process went to sleep.
long sleeps_of(pid_t process) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  for (std::string word; status >> word;)
    if (long count = 0; word == "voluntary_ctxt_switches:" && status >> count) return count;
  return 0;
}

// [s]; NaN if the current never ended, < 0 if it ended before: the machine was busy.
double time_to_zero(const row& r) {
  const ph::shared_memory<device> shared;
  device& d = *shared;
  const pid_t loop = fork();
  if (loop == 0) {
    if (r.threaded) drive(d, ph::threaded_port(memory_port{&d}));
    else drive(d, memory_port{&d});
    _exit(0);
  }
  const auto after = [](double seconds) { return ph::monotonic_seconds() + seconds; };
  const auto wait_for = [](double end, const auto& condition) {
    while (!condition() && ph::monotonic_seconds() < end) usleep(200);
  };
  wait_for(after(5), [&] { return d.current > 0; });
  usleep(30'000 + static_cast<unsigned>(std::rand()) % 5'000);  // the phase of the supervisor's looks
  // The worst moment is just after a cycle; for the supervisor, just after its look that followed one
  for (bool is_worst = false; !is_worst && d.current > 0;) {
    for (const std::uint32_t before = d.writes; d.current > 0 && d.writes == before;) {
    }
    if (!r.to_supervisor) break;
    const long looks = sleeps_of(d.supervisor);
    usleep(150);
    is_worst = sleeps_of(d.supervisor) != looks;
  }
  const pid_t target = r.to_supervisor ? d.supervisor.load() : loop;
  const double happened = ph::monotonic_seconds();
  if (r.what != trouble::none) d.what = r.what;
  else if (target > 0) kill(target, r.signal);
  // It must also stay off
  const auto is_off = [&] { return d.current == 0; };
  for (const double end = after(1); ph::monotonic_seconds() < end;) {
    wait_for(end, is_off);
    usleep(10'000);
    if (is_off()) break;
  }
  const double time = is_off() ? d.ended - happened : std::numeric_limits<double>::quiet_NaN();
  kill(loop, SIGKILL);
  if (d.supervisor > 0) kill(d.supervisor, SIGKILL);
  while (wait(nullptr) > 0) {  // the supervisor, too, as this process adopts it
  }
  return time;
}

double stated(std::string_view begins) {
  for (const ph::hazard& h : ph::hazards())
    if (h.what.starts_with(begins)) return h.max_time;
  std::fprintf(stderr, "error: hazards() has none that begins with '%s'\n", std::string(begins).c_str());
  std::exit(1);
}

struct spread {
  std::vector<double> all;  // [s]
  double at(double share) const {
    return all[static_cast<std::size_t>(share * static_cast<double>(all.size() - 1))];
  }
};
spread sorted(std::vector<double> all) {
  std::sort(all.begin(), all.end());
  return {std::move(all)};
}

// The lateness with which this machine wakes a process, as in hazards().
spread wake_ups() {
  std::vector<double> late;
  for (int k = 0; k < 500; ++k) {
    const double before = ph::monotonic_seconds();
    poll(nullptr, 0, 2);
    late.push_back(ph::monotonic_seconds() - before - 2e-3);
  }
  return sorted(std::move(late));
}

// Prints a row; whether it is as stated: its longest trial takes at most the stated time, and no more than a
// period less.
bool print_row(const row& r, int trials) {
  std::vector<double> times;
  int never = 0;
  for (int k = 0; k < trials; ++k) {
    const double time = time_to_zero(r);
    if (std::isnan(time)) ++never;
    else if (time >= 0) times.push_back(time);
  }
  const double longest = stated(r.hazard), period = ph::control_loop_parameters().period;
  const spread seen = sorted(times.empty() ? std::vector{std::numeric_limits<double>::quiet_NaN()} : times);
  const double max = seen.at(1);
  const bool is_over = never > 0 || !(max <= longest), is_sooner = !r.at_most && max < longest - period;
  std::printf("%-47s %-24s %7.2f %8.2f %8.2f %8.2f  %s\n", std::string(r.hazard).c_str(), r.how,
              1e3 * longest, 1e3 * seen.at(0), 1e3 * seen.at(0.5), 1e3 * max,
              never > 0   ? "never in some trials"
              : is_over   ? "longer than stated"
              : is_sooner ? "more than a period sooner"
                          : "as stated");
  std::fflush(stdout);
  return !is_over && !is_sooner;
}

}  // namespace

int main(int argc, char** argv) {
  const int trials = argc > 1 ? std::atoi(argv[1]) : 20;
  const std::string only = argc > 2 ? argv[2] : "";
  if (trials < 1) return std::fprintf(stderr, "usage: hazards [TRIALS [TEXT OF A ROW]]\n"), 2;
  prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0);
  const spread late = wake_ups();
  std::printf(
      "The kernel wakes a process %.3f ms late (median), %.3f ms (99 of 100); hazards() allows %.3f ms.\n"
      "Time from the hazard to 0 A [ms], of %d trials:\n\n%-47s %-24s %7s %8s %8s %8s\n",
      1e3 * late.at(0.5), 1e3 * late.at(0.99), 1e3 * ph::driver_timing().wake_up, trials, "hazard", "how",
      "stated", "min", "median", "max");
  int as_stated = 0, printed = 0;
  for (const row& r : rows) {
    if (std::string(r.hazard).append(" ").append(r.how).find(only) == std::string::npos) continue;
    as_stated += print_row(r, trials);
    ++printed;
  }
  std::printf("\nsummary: %d of %d rows as stated, by the longest of %d trials, if the machine is idle\n",
              as_stated, printed, trials);
}
