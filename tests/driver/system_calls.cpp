// slow
// What a cycle of the whole driver asks of the kernel: to sleep, and nothing else.
#include "../realtime/allocations.hpp"
#include "loopback_socket.hpp"
#include "serial_peer.hpp"
#include "system_call_filter.hpp"

#include <gtest/gtest.h>
#include <passive_haptics/driver/calibration/device_calibration.hpp>
#include <passive_haptics/driver/control_loop.hpp>
#include <passive_haptics/driver/process/recorder.hpp>
#include <passive_haptics/driver/process/supervisor.hpp>
#include <passive_haptics/driver/safe_port.hpp>
#include <passive_haptics/driver/stop_signals.hpp>
#include <passive_haptics/driver/thread/threaded_port.hpp>
#include <passive_haptics/passive_haptics.hpp>
#include <ports/net_ft.hpp>
#include <serial/serial_port.hpp>

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>

namespace ph = passive_haptics;

namespace {

using arm = ph::tendon_two_link<double>;

// How the process that drives ended, if not by a signal.
enum ending : int { well = 0, no_filter, no_start, allocated, never_braked };

// A device in memory whose handle goes along a wall, a little way inside, while a hand presses on it.
struct memory_port {
  static constexpr int encoder_count = 2, brake_count = 2;
  std::uint32_t sequence = 0;

  std::string open() { return {}; }
  ph::port_status read(ph::port_sample<2>& sample) noexcept {
    const double way = 0.05 * std::sin(0.01 * ++sequence);
    sample = {
        ph::monotonic_seconds(), sequence, {std::floor(1000 * way), std::floor(-800 * way)}, {true, true}};
    return ph::port_status::ok;
  }
  ph::port_status write(const ph::brake_currents<2>&) noexcept { return ph::port_status::ok; }
  void release() noexcept {}
};

struct memory_sensor {
  static constexpr int channel_count = 2;
  std::uint32_t sequence = 0;

  std::string open() { return {}; }
  ph::port_status read(ph::port_sample<2>& sample) noexcept {
    sample = {ph::monotonic_seconds(), ++sequence, {1.5, 2}, {true, true}};
    return ph::port_status::ok;
  }
};

struct record {
  double time;
  std::array<double, 2> current;
};

struct nowhere {
  std::string open() { return {}; }
  void take(const record&) {}
  void rest(std::uint64_t) {}
  void close() {}
};

constexpr int cycles = 2000;

// Cycles of a process that may only sleep from the tenth on.
class filtered_cycles {
 public:
  // Before each cycle.
  void begin() {
    if (number_ != 10) return;
    has_filter_ = system_calls::allow_only(
        std::array<unsigned, 3>{SYS_clock_nanosleep, SYS_clock_gettime, SYS_exit_group});
    before_ = allocations;
    Eigen::internal::set_is_malloc_allowed(false);
  }
  int number() const { return number_; }
  // After each: whether another one follows.
  bool end() { return has_filter_ && ++number_ < cycles; }
  // Ends the process. Not by _exit(), nor told to be [[noreturn]]: before these a sanitizer makes calls of
  // its own.
  void end_process(bool braked) const {
    syscall(SYS_exit_group, !has_filter_             ? no_filter
                            : allocations != before_ ? allocated
                            : braked                 ? well
                                                     : never_braked);
  }

 private:
  int number_ = 0;
  long before_ = 0;
  bool has_filter_ = true;
};

// In a process of its own, which ends there: to put away what is used here takes other calls.
[[noreturn]] void drive(bool one_call_more) {
  const arm mechanism;
  const ph::vector<double, 2> home = mechanism.inverse({0.08, 0.2255}, ph::elbow::left).q;
  ph::device_calibration<arm, 2, ph::planar_sensor_frame<2>> calibration(
      mechanism, {}, ph::planar_sensor_frame<2>{.link = {1, 1}});
  calibration.encoders.set_zero_count(-calibration.encoders.counts(calibration.axis_positions(home)));
  ph::world_walls<2> walls;
  walls.add(ph::wall(ph::half_space<2>({0, 0.225}, {0, -1}), 1e4));
  ph::controller<arm, ph::world<2>, ph::direct_control> control(mechanism, {}, ph::world<2>(walls),
                                                                ph::direct_control());
  ph::recorder<record, nowhere> log(nowhere{});
  ph::supervisor<memory_port> guard(memory_port{}, {.timeout = 10});
  ph::safe_port_parameters<2, 2> limits;
  limits.hold_over = 10;  // of this nothing is tested here
  ph::safe_port<memory_port, memory_sensor> port(memory_port{}, memory_sensor{}, limits);
  if (!log.start().empty() || !guard.start().empty() || !port.open().empty()) _exit(no_start);
  ph::stop_signals signals;
  ph::control_loop loop(
      ph::control_loop_parameters{.period = 2e-4, .max_overruns = 1'000'000, .max_sleep = 10});

  filtered_cycles run;
  bool braked = false;
  loop.run(
      [&](const ph::loop_cycle& now) {
        run.begin();
        if (one_call_more && run.number() == cycles / 2) syscall(SYS_getppid);
        if (!guard.beat(now.time, port.applied())) port.release({ph::fault::supervisor_lost});
        port.read(now.time);
        if (signals.rearm(port.state() == ph::port_state::released)) port.rearm();
        port.activate();
        auto state = calibration.state(port.position_time(), port.position(), port.force());
        state.time = now.time;
        port.write(calibration.currents(control(state).capacity));
        log({now.time, port.applied()});
        braked = braked || port.applied() != ph::brake_currents<2>{};
        return run.end();
      },
      [&] { return signals.stop() != 0; }, [&](ph::fault why) { port.release({why}); });
  run.end_process(braked);
  __builtin_unreachable();
}

// A board on a pseudo-terminal and a force sensor on the loopback interface, which live in a thread.
class devices {
 public:
  devices() : board({.watchdog = 60'000}) {
    life_ = std::thread([this] { live(); });
    life_.detach();  // it ends with the process
  }

  serial_peer board;
  loopback_socket sensor;

 private:
  void live() {
    std::array<std::uint32_t, 9> record{};
    for (;; usleep(1000)) {
      board.hear();
      board.tick();
      std::array<std::uint8_t, 8> request;
      while (sensor.receive(request.data(), request.size()) > 0) {
      }
      record[0] = htonl(ntohl(record[0]) + 1);
      if (sensor.peer().sin_port != 0) sensor.send(record.data(), sizeof record);
    }
  }

  std::thread life_;
};

using serial_port = example::serial_port<2, 2>;

// Ports to real devices, in a process of their own.
template <class Port, class Sensor>
[[noreturn]] void drive_devices() {
  devices all;
  example::serial_port_parameters line;
  line.device = all.board.path();
  line.open_timeout = 20;
  example::net_ft_parameters sensor;
  sensor.host = "127.0.0.1";
  sensor.port = all.sensor.port();
  sensor.open_timeout = 20;
  ph::safe_port_parameters<2, 6> limits;
  limits.hold_over = 10;  // of this nothing is tested here
  ph::safe_port<Port, Sensor> port(Port{serial_port(line)}, Sensor{example::net_ft(sensor)}, limits);
  if (!port.open().empty()) _exit(no_start);
  ph::control_loop loop(
      ph::control_loop_parameters{.period = 1e-3, .max_overruns = 1'000'000, .max_sleep = 10});
  filtered_cycles run;
  bool braked = false;
  loop.run(
      [&](const ph::loop_cycle& now) {
        run.begin();
        port.read(now.time);
        port.activate();
        port.write({0.1, 0.2});
        if (run.number() == cycles / 4) port.release();  // and it may go on
        port.rearm();
        braked = braked || (run.number() > cycles / 2 && port.applied() != ph::brake_currents<2>{});
        return run.end();
      },
      [] { return false; }, [&](ph::fault why) { port.release({why}); });
  run.end_process(braked);
  __builtin_unreachable();
}

template <class Drive>
int ending_of(Drive&& drives) {
  const pid_t driver = fork();
  if (driver == 0) drives();
  int status = 0;
  waitpid(driver, &status, 0);
  return status;
}

// A kernel without filters can show none of this.
class a_cycle_of_the_driver : public ::testing::Test {
 protected:
  void SetUp() override {
    const int status = ending_of([] {
      syscall(SYS_exit_group,
              system_calls::allow_only(std::array<unsigned, 1>{SYS_exit_group}) ? well : no_filter);
    });
    if (WIFEXITED(status) && WEXITSTATUS(status) == no_filter)
      GTEST_SKIP() << "the kernel has no seccomp filters";
  }
};

class a_cycle_at_devices : public a_cycle_of_the_driver {
 protected:
  void SetUp() override {
    a_cycle_of_the_driver::SetUp();
    if (const std::string missing = missing_pseudo_terminal(); !missing.empty()) GTEST_SKIP() << missing;
  }
};

void expect_well(int status) {
  ASSERT_TRUE(WIFEXITED(status)) << "died of signal " << WTERMSIG(status);
  EXPECT_EQ(WEXITSTATUS(status), well);
}
void expect_found_out(int status) {
  ASSERT_TRUE(WIFSIGNALED(status)) << "ended with " << WEXITSTATUS(status);
  EXPECT_EQ(WTERMSIG(status), SIGSYS);
}

}  // namespace

TEST_F(a_cycle_of_the_driver, makes_no_system_call_but_to_sleep_and_allocates_nothing) {
  expect_well(ending_of([] { drive(false); }));
}
TEST_F(a_cycle_of_the_driver, that_makes_one_more_system_call_is_found_out) {
  expect_found_out(ending_of([] { drive(true); }));
}

TEST_F(a_cycle_at_devices, makes_no_system_call_but_to_sleep) {
  expect_well(ending_of(drive_devices<ph::threaded_port<serial_port>, ph::threaded_sensor<example::net_ft>>));
}
TEST_F(a_cycle_at_devices, that_calls_its_serial_line_itself_is_found_out) {
  expect_found_out(ending_of(drive_devices<serial_port, ph::threaded_sensor<example::net_ft>>));
}
