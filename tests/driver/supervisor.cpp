// together
#include "processes.hpp"

#include <passive_haptics/driver/control_loop.hpp>
#include <passive_haptics/driver/process/recorder.hpp>
#include <passive_haptics/driver/process/supervisor.hpp>
#include <passive_haptics/driver/safe_port.hpp>
#include <passive_haptics/driver/stop_signals.hpp>
#include <passive_haptics/driver/thread/threaded_port.hpp>

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/prctl.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <optional>
#include <vector>

namespace ph = passive_haptics;

namespace supervisor_tests {

// A device whose analog outputs keep their last value, whoever dies.
struct outputs {
  std::atomic<double> current = 0;
  std::atomic<std::uint32_t> writes = 0, releases = 0, samples = 0;
  std::atomic<std::int64_t> released_at = 0;             // [ns]
  std::atomic<std::uint32_t> recorded = 0, written = 0;  // by the loop, by the recorder at its end
  std::atomic<bool> in_order = true;
  std::atomic<bool> after_stop = false;
  std::atomic<pid_t> supervisor = 0;

  // What was written, by which process, and when [s]
  struct entry {
    std::atomic<double> time = 0, current = 0;
    std::atomic<pid_t> by = 0;
  };
  std::atomic<std::uint32_t> entries = 0;
  std::array<entry, 1 << 15> history{};
  void note(double amperes) {
    current = amperes;
    entry& one = history[entries++ % history.size()];
    one.time = ph::monotonic_seconds();
    one.current = amperes;
    one.by = getpid();
  }
};

struct keeping_port {
  static constexpr int encoder_count = 1, brake_count = 1;
  outputs* device;
  std::string missing{};

  std::string open() { return missing; }
  ph::port_status read(ph::port_sample<1>& sample) noexcept {
    sample = {ph::monotonic_seconds(), ++device->samples, {0}, {true}};
    return ph::port_status::ok;
  }
  ph::port_status write(const ph::brake_currents<1>& currents) noexcept {
    device->note(currents[0]);
    ++device->writes;
    return ph::port_status::ok;
  }
  double watchdog() const noexcept { return 1e9; }  // of processes alone is told here
  void release() noexcept {
    device->note(0);
    device->released_at = ph::monotonic_clock().now();
    ++device->releases;
  }
};
static_assert(ph::BrakePort<keeping_port>);

// Notes that each number came after the one before, and that the recorder ended.
struct counting_sink {
  outputs* device;
  std::uint32_t count = 0;

  std::string open() { return {}; }
  void take(const std::uint32_t& number) { device->in_order = device->in_order && number == count++; }
  void rest(std::uint64_t) {}
  void close() { device->written = count; }
};

ph::release_parameters hold_for(double seconds) {
  return {.policy = ph::release_policy::hold, .hold_time = seconds};
}
ph::current_limits<1> limits_of_heat(double heat) {
  return {.max_current = {1}, .continuous = {0.4}, .heat = {heat}};
}

struct a_supervised_loop : ::testing::Test {
  ph::shared_memory<outputs> device;
  pid_t loop = -1;

  ph::release_parameters at_release;

  // The supervisor of a loop that died becomes a child of the test, which so sees it end
  a_supervised_loop() { prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0); }
  ~a_supervised_loop() override {
    if (loop > 0) kill(loop, SIGKILL), processes::end_of(loop);
  }

  // Forks a process as brake drivers are; `each` may spoil a cycle.
  void start(const std::function<void(int)>& each = nullptr, double timeout = 0.2) {
    loop = fork();
    ASSERT_GE(loop, 0);
    if (loop == 0) {
      setpgid(0, 0);
      processes::obey_signals();
      _exit(drive(each, timeout));
    }
    // The supervisor hears of a current with the next heartbeat
    ASSERT_TRUE(eventually([&] { return device->writes > 5 && device->current == 0.5; })) << "the loop runs";
  }

  int drive(const std::function<void(int)>& each, double timeout) {
    ph::recorder<std::uint32_t, counting_sink> record(counting_sink{&*device});
    ph::supervisor<keeping_port> guard(keeping_port{&*device}, {.timeout = timeout}, at_release);
    ph::safe_port_parameters<1, 0> p;
    p.hold_over = 10;  // of this nothing is tested here
    p.at_release = at_release;
    ph::safe_port<keeping_port> port(keeping_port{&*device}, {}, p);
    if (!record.start().empty() || !guard.start().empty() || !port.open().empty()) return 2;
    device->supervisor = guard.pid();
    const ph::stop_signals signals;
    ph::control_loop loop_at_1_khz(ph::control_loop_parameters{.max_overruns = 1000000, .max_sleep = 1e9});
    int k = 0;
    const auto report = loop_at_1_khz.run(
        [&](const ph::loop_cycle& now) {
          if (!guard.beat(now.time, port.applied()))
            port.release({ph::fault::supervisor_lost}, guard.began());
          port.read(now.time);
          port.activate();
          if (each) each(k);
          port.write({0.5});
          if (record(static_cast<std::uint32_t>(k))) device->recorded = static_cast<std::uint32_t>(k + 1);
          ++k;
          device->after_stop =
              port.state() == ph::port_state::released && port.reason().what == ph::fault::supervisor_lost;
          return true;
        },
        [&] { return signals.stop() != 0; }, [&](ph::fault why) { port.release({why}); });
    return report.ended_by == ph::fault::none ? 0 : 1;
  }

  // Every number that the loop recorded, in order.
  void expect_all_recorded() {
    EXPECT_TRUE(eventually([&] { return device->written > 0; }));
    EXPECT_TRUE(device->in_order);
    EXPECT_GE(device->written, device->recorded);
  }

  // A supervisor of the test itself, as its loop has one.
  std::optional<ph::supervisor<keeping_port>> guard;
  void start_guard(const ph::supervisor_parameters& p, const ph::release_parameters& at_release = {},
                   const ph::current_limits<1>& limits = {}) {
    guard.emplace(keeping_port{&*device}, p, at_release, limits);
    ASSERT_EQ(guard->start(), "");
    device->supervisor = guard->pid();
  }
  bool comes_to_zero() {
    return eventually([&] { return device->current == 0; });
  }

  int end_of_loop() { return processes::end_of(std::exchange(loop, -1)); }

  // What the supervisor's process wrote: where it begins, the release policy is to be seen.
  struct written {
    double time, current;
  };
  std::vector<written> by_supervisor() const {
    std::vector<written> all;
    const std::size_t count = std::min<std::size_t>(device->entries, device->history.size());
    for (std::size_t i = 0; i < count; ++i)
      if (const auto& one = device->history[i]; one.by == device->supervisor)
        all.push_back({one.time, one.current});
    return all;
  }
  // The same after SIGKILL of the loop, until the supervisor has ended; `killed`: when that was [s].
  std::vector<written> by_supervisor_of_a_killed_loop(double& killed) {
    killed = ph::monotonic_seconds();
    kill(loop, SIGKILL);
    end_of_loop();
    EXPECT_TRUE(supervisor_is_gone());
    return by_supervisor();
  }
  bool supervisor_is_gone() const {
    return eventually([this] { return waitpid(device->supervisor, nullptr, WNOHANG) != 0; });
  }
};

class a_signal : public a_supervised_loop, public ::testing::WithParamInterface<int> {};

TEST_P(a_signal, that_kills_the_loop_leaves_no_current_and_no_record_behind) {
  start();
  const std::int64_t killed = ph::monotonic_clock().now();
  kill(GetParam() == SIGQUIT ? -loop : loop, GetParam());  // Ctrl-\ goes to the whole group
  const int status = end_of_loop();
  EXPECT_FALSE(WIFEXITED(status) && WEXITSTATUS(status) == 0);  // a sanitizer ends it in its own way
  EXPECT_TRUE(comes_to_zero());
  std::printf("0 A %.1f ms after %s\n", 1e-6 * static_cast<double>(device->released_at - killed),
              strsignal(GetParam()));
  expect_all_recorded();
}
INSTANTIATE_TEST_SUITE_P(each, a_signal, ::testing::Values(SIGKILL, SIGSEGV, SIGABRT, SIGBUS, SIGQUIT),
                         [](const auto& one) { return std::string("SIG").append(sigabbrev_np(one.param)); });

TEST_F(a_supervised_loop, that_is_killed_beside_a_stopped_supervisor_leaves_no_current) {
  start();
  kill(device->supervisor, SIGSTOP);
  kill(loop, SIGKILL);
  end_of_loop();
  EXPECT_TRUE(comes_to_zero());
  EXPECT_TRUE(supervisor_is_gone());
}

// The time of a ramp is read by the supervisor between two writes, so that what it writes lies between the
// ramp at this write and at the one before.
TEST_F(a_supervised_loop, that_is_killed_ramps_down_where_the_user_says_so) {
  at_release = {.policy = ph::release_policy::ramp, .ramp_time = 0.4};
  start();
  double killed = 0;
  const auto all = by_supervisor_of_a_killed_loop(killed);
  ASSERT_GE(all.size(), 3u);
  double before = killed;
  for (const auto& [time, current] : all) {
    EXPECT_LE(current, 0.5);
    EXPECT_GE(current, 0.5 * (1 - (time - killed) / 0.4) - 1e-9) << time - killed << " s after SIGKILL";
    // It may have begun late
    EXPECT_LE(current, 0.5 * std::clamp(1 - (before - all.front().time) / 0.4, 0.0, 1.0) + 1e-9);
    before = time;
  }
  EXPECT_GT(all.front().current, 0.25) << "no step";
  EXPECT_EQ(device->current, 0);
}

TEST_F(a_supervised_loop, that_is_killed_holds_so_long_as_the_user_says) {
  at_release = hold_for(0.3);
  start();
  double killed = 0;
  const auto all = by_supervisor_of_a_killed_loop(killed);
  ASSERT_GE(all.size(), 2u);
  for (std::size_t k = 0; k + 1 < all.size(); ++k) EXPECT_EQ(all[k].current, 0.5);
  EXPECT_GE(all.back().time - killed, 0.3);
  EXPECT_EQ(all.back().current, 0);
}

TEST_F(a_supervised_loop, that_holds_too_warm_a_coil_gives_it_less_in_the_end) {
  ASSERT_NO_FATAL_FAILURE(start_guard({.timeout = 0.02}, hold_for(100), limits_of_heat(0.01)));
  guard->beat(1, {0.5});  // 0.11 s until it is too warm
  EXPECT_TRUE(eventually([&] { return device->current == 0.5; }));
  EXPECT_TRUE(eventually([&] { return device->current < 0.4; }));
  EXPECT_NEAR(device->current, 0.38, 1e-12);
  guard->stop();
  EXPECT_EQ(device->current, 0);
}

// 0.09 A^2 s over what may flow for ever in each second: the limit is passed before the release.
TEST_F(a_supervised_loop, warmed_its_coils_already_before_it_fell_silent) {
  ASSERT_NO_FATAL_FAILURE(start_guard({.timeout = 0.2}, hold_for(100), limits_of_heat(0.01)));
  guard->beat(1, {0.5});
  ASSERT_TRUE(eventually([&] { return by_supervisor().size() > 5; }));
  for (const auto& one : by_supervisor()) ASSERT_NEAR(one.current, 0.38, 1e-12);
  kill(guard->pid(), SIGKILL);  // it would hold on, and be waited for
}

// And here it is far from passed when 30 currents are given.
TEST_F(a_supervised_loop, warmed_its_coils_by_no_more_than_flowed) {
  ASSERT_NO_FATAL_FAILURE(start_guard({.timeout = 0.05}, hold_for(100), limits_of_heat(0.3)));
  for (const double start = ph::monotonic_seconds(); ph::monotonic_seconds() < start + 0.3; usleep(1000))
    guard->beat(1, {0.5});
  ASSERT_TRUE(eventually([&] { return by_supervisor().size() >= 30; }));
  const auto all = by_supervisor();
  for (std::size_t k = 0; k < 30; ++k) ASSERT_EQ(all[k].current, 0.5) << k;
  kill(guard->pid(), SIGKILL);
}

TEST_F(a_supervised_loop, that_is_killed_while_its_supervisor_ramps_down_gets_no_second_ramp) {
  at_release = {.policy = ph::release_policy::ramp, .ramp_time = 0.6};
  start();
  kill(loop, SIGSTOP);
  ASSERT_TRUE(eventually([&] { return device->current < 0.3; }));
  double killed = 0;
  const auto all = by_supervisor_of_a_killed_loop(killed);
  double before = 0.5;
  for (const auto& one : all) {
    ASSERT_LE(one.current, before);
    before = one.current;
  }
  EXPECT_EQ(before, 0);
}

TEST_F(a_supervised_loop, that_goes_on_takes_up_the_ramp_of_its_supervisor) {
  at_release = {.policy = ph::release_policy::ramp, .ramp_time = 2};
  start();
  kill(loop, SIGSTOP);
  ASSERT_TRUE(eventually([&] { return device->current < 0.4; }));
  EXPECT_GT(by_supervisor().size(), 15u) << "smoother than a look in each 50 ms of the 0.4 s so far";
  const std::uint32_t continued = device->entries;
  kill(loop, SIGCONT);
  ASSERT_TRUE(comes_to_zero());
  const auto first = by_supervisor().front();
  const double began = first.time - 2 * (1 - first.current / 0.5);
  double before = 0.4;
  int stale = 0, by_loop = 0;
  for (std::size_t k = continued; k < std::min<std::size_t>(device->entries, device->history.size()); ++k) {
    const double now = device->history[k].current;
    by_loop += device->history[k].by == loop;
    if (now > before + 0.005) ++stale;  // the two read their clocks one after the other
    else before = now;
    EXPECT_GE(now, 0.5 * (1 - (device->history[k].time - began) / 2) - 0.02) << "the same ramp";
  }
  EXPECT_LE(stale, 1) << "but for what it was about to write when it was stopped";
  EXPECT_GT(by_loop, 10);
}

class a_request : public a_supervised_loop, public ::testing::WithParamInterface<int> {};

TEST_P(a_request, to_stop_releases_first_and_ends_the_loop) {
  start();
  kill(loop, GetParam());
  const int status = end_of_loop();
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  EXPECT_EQ(device->current, 0);
  expect_all_recorded();
}
INSTANTIATE_TEST_SUITE_P(each, a_request, ::testing::Values(SIGINT, SIGTERM, SIGHUP),
                         [](const auto& one) { return std::string("SIG").append(sigabbrev_np(one.param)); });

TEST_F(a_supervised_loop, whose_law_throws_leaves_no_current) {
  start([](int k) {
    if (k == 50) throw std::runtime_error("a law");
  });
  const int status = end_of_loop();
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 1);
  EXPECT_EQ(device->current, 0);
  expect_all_recorded();
}

TEST_F(a_supervised_loop, that_is_stopped_is_released_and_stays_so_when_it_goes_on) {
  start();
  kill(loop, SIGSTOP);
  EXPECT_TRUE(comes_to_zero());
  kill(loop, SIGCONT);
  EXPECT_TRUE(eventually([&] { return device->after_stop.load(); })) << "the loop releases its own port";
  for (int k = 0; k < 50; ++k) {
    usleep(1000);
    ASSERT_EQ(device->current, 0);
  }
  kill(loop, SIGINT);
  end_of_loop();
  expect_all_recorded();
}

TEST_F(a_supervised_loop, does_not_go_on_without_its_supervisor) {
  ASSERT_NO_FATAL_FAILURE(start_guard({}));
  EXPECT_FALSE(guard->alive()) << "nobody knows yet";
  EXPECT_TRUE(guard->beat(1, {}));
  EXPECT_TRUE(guard->beat(1.05, {}));
  EXPECT_TRUE(guard->alive());
  const auto alive_at = [&](double time) {
    guard->beat(time, {});
    return guard->alive();
  };
  EXPECT_TRUE(eventually([&] { return alive_at(1.5); })) << "it looked since";
  kill(guard->pid(), SIGKILL);
  siginfo_t ended;
  ASSERT_EQ(waitid(P_PID, static_cast<id_t>(guard->pid()), &ended, WEXITED | WNOWAIT), 0);
  EXPECT_TRUE(alive_at(1.55)) << "it may have looked once more";
  EXPECT_TRUE(alive_at(1.59));
  EXPECT_FALSE(alive_at(1.66)) << "nothing to rearm with";
  EXPECT_FALSE(guard->beat(1.67, {}));
  ASSERT_NO_FATAL_FAILURE(start_guard({.timeout = 10}));
  EXPECT_TRUE(guard->beat(1, {}));
  EXPECT_TRUE(guard->beat(3, {})) << "it looks every 2.5 s";
  EXPECT_FALSE(guard->beat(11.1, {}));
}

TEST_F(a_supervised_loop, can_be_rearmed_after_it_was_released) {
  ASSERT_NO_FATAL_FAILURE(start_guard({.timeout = 0.05}));
  usleep(100'000);
  EXPECT_FALSE(guard->released()) << "the first heartbeat starts the watch";
  const double before = ph::monotonic_seconds();
  EXPECT_TRUE(guard->beat(1, {0.25}));
  EXPECT_FALSE(guard->began());
  EXPECT_TRUE(eventually([&] { return guard->released(); }));
  ASSERT_TRUE(guard->began());
  EXPECT_EQ(guard->began()->flowing, (ph::brake_currents<1>{0.25}));
  EXPECT_GE(guard->began()->time, before);
  EXPECT_LE(guard->began()->time, ph::monotonic_seconds());
  EXPECT_FALSE(guard->beat(1.01, {}));
  EXPECT_TRUE(eventually([&] { return device->releases >= 1; })) << "it says so before";
  guard->rearm();
  EXPECT_FALSE(guard->began());
  EXPECT_TRUE(guard->beat(1.02, {}));
  device->current = 1;
  guard->stop();
  EXPECT_EQ(device->current, 0) << "released once more at its end";
}

// A port whose read may not return, as one that waits for the lock of a card's driver.
struct blocking_port : keeping_port {
  std::atomic<bool>* blocks;
  ph::port_status read(ph::port_sample<1>& sample) noexcept {
    while (*blocks) usleep(1000);
    return keeping_port::read(sample);
  }
};

TEST_F(a_supervised_loop, whose_port_does_not_come_back_is_released) {
  std::atomic<bool> blocks = false;
  const blocking_port one{{&*device}, &blocks};
  ph::supervisor<blocking_port> guard_of_it(one, {.timeout = 0.1});
  ASSERT_EQ(guard_of_it.start(), "");
  ph::safe_port_parameters<1, 0> p;
  p.hold_over = 0.05;
  ph::safe_port<ph::threaded_port<blocking_port>> port(ph::threaded_port<blocking_port>(one), {}, p);
  ASSERT_EQ(port.open(), "");
  const auto cycle = [&] {
    const double now = ph::monotonic_seconds();
    port.read(now);
    port.activate();
    if (!guard_of_it.beat(now, port.applied()))
      port.release({ph::fault::supervisor_lost}, guard_of_it.began());
    port.write({0.5});
  };
  ASSERT_TRUE(eventually([&] { return cycle(), device->current == 0.5; }));
  blocks = true;
  const double blocked = ph::monotonic_seconds();
  EXPECT_TRUE(eventually([&] { return cycle(), device->current == 0; }));
  std::printf("0 A %.0f ms after the read began to block\n",
              1e3 * (1e-9 * static_cast<double>(device->released_at) - blocked));
  EXPECT_EQ(port.state(), ph::port_state::released);
  for (int k = 0; k < 50; ++k) {
    cycle();
    usleep(1000);
    ASSERT_EQ(device->current, 0);
  }
  blocks = false;
  EXPECT_TRUE(eventually([&] { return cycle(), port.applied() == ph::brake_currents<1>{}; }))
      << "confirmed: its heart beats again";
}

// The loop beats, but does not know what flows: its port did not confirm a release.
TEST_F(a_supervised_loop, that_does_not_know_what_flows_gives_no_heartbeat) {
  ASSERT_NO_FATAL_FAILURE(start_guard({.timeout = 0.05}));
  ASSERT_TRUE(guard->beat(1, {0.25}));
  device->current = 0.25;
  EXPECT_TRUE(eventually([&] {
    guard->beat(1, {std::numeric_limits<double>::quiet_NaN()});
    return guard->released();
  }));
  EXPECT_EQ(guard->began()->flowing, (ph::brake_currents<1>{0.25})) << "the last that was known";
  EXPECT_TRUE(comes_to_zero());
}

// hold_time begins anew with each beat, also after a silence that the loop survived.
TEST_F(a_supervised_loop, that_fell_silent_once_is_held_for_the_whole_time_when_it_dies_later) {
  ASSERT_NO_FATAL_FAILURE(start_guard({.timeout = 0.05}, hold_for(0.5)));
  guard->beat(1, {0.5});
  ASSERT_TRUE(eventually([&] { return guard->released(); }));
  for (const double start = ph::monotonic_seconds(); ph::monotonic_seconds() < start + 0.6; usleep(1000))
    guard->beat(1, {0.5});
  const std::size_t before = by_supervisor().size();
  ASSERT_TRUE(eventually([&] { return by_supervisor().size() > before; })) << "silent again";
  EXPECT_EQ(by_supervisor()[before].current, 0.5);
  kill(guard->pid(), SIGKILL);  // it would hold on, and be waited for
}

// Stopped, held to the end by the supervisor, continued: nothing may flow, whoever dies then.
TEST_F(a_supervised_loop, whose_hold_is_over_stays_without_current) {
  at_release = hold_for(0.3);
  start();
  kill(loop, SIGSTOP);
  ASSERT_TRUE(comes_to_zero());
  const std::uint32_t continued = device->entries;
  kill(loop, SIGCONT);
  ASSERT_TRUE(eventually([&] { return device->after_stop.load(); }));
  ASSERT_TRUE(eventually([&] { return device->entries > continued + 200; }));
  double killed = 0;
  by_supervisor_of_a_killed_loop(killed);
  int flowed = 0;
  for (std::size_t k = continued; k < std::min<std::size_t>(device->entries, device->history.size()); ++k)
    flowed += device->history[k].current != 0;
  EXPECT_LE(flowed, 1) << "but for what it was about to write when it was stopped";
  EXPECT_EQ(device->current, 0);
}

TEST_F(a_supervised_loop, that_writes_after_a_release_is_released_again) {
  ASSERT_NO_FATAL_FAILURE(start_guard({.timeout = 0.05}));
  guard->beat(1, {});
  ASSERT_TRUE(eventually([&] { return guard->released(); }));
  for (int k = 0; k < 3; ++k) {
    device->current = 1;
    EXPECT_TRUE(comes_to_zero()) << "time " << k;
  }
}

TEST_F(a_supervised_loop, gives_its_supervisor_the_priority_that_it_may) {
  const pid_t asker = fork();
  if (asker == 0) {
    sched_param wanted{};
    wanted.sched_priority = 1;
    _exit(sched_setscheduler(0, SCHED_FIFO, &wanted) == 0 ? 0 : 1);
  }
  const bool may = processes::end_of(asker) == 0;
  for (const int priority : {1, 0}) {
    ASSERT_NO_FATAL_FAILURE(start_guard({.priority = priority}));
    EXPECT_TRUE(eventually([&] {
      sched_param is{};
      return sched_getparam(guard->pid(), &is) == 0 && is.sched_priority == (may ? priority : 0);
    })) << priority;
  }
}

TEST_F(a_supervised_loop, waits_for_no_stopped_supervisor_without_end) {
  ASSERT_NO_FATAL_FAILURE(start_guard({}));
  const pid_t process = guard->pid();
  kill(process, SIGSTOP);
  device->current = 1;
  guard->stop();
  EXPECT_EQ(device->current, 0) << "it was woken, and released once more";
  EXPECT_NE(kill(process, 0), 0);
}

TEST_F(a_supervised_loop, has_no_supervisor_that_finds_no_device) {
  guard.emplace(keeping_port{&*device, "no /dev/comedi7"});
  EXPECT_EQ(guard->start(), "no /dev/comedi7");
  EXPECT_LE(guard->pid(), 0);
}

TEST(a_supervisor, checks_its_parameters) {
  EXPECT_EQ(validate(ph::supervisor_parameters{}), "");
  EXPECT_DOUBLE_EQ(ph::supervisor_parameters{.timeout = 0.2}.latest(), 0.25);
  EXPECT_DOUBLE_EQ(ph::supervisor_parameters{.timeout = 0.2}.latest(1e-4), 0.2505);
  EXPECT_EQ(ph::supervisor_parameters{.timeout = 0.2}.look(), 0.05);
  EXPECT_EQ(ph::supervisor_parameters{.timeout = 0.009}.look(), 0.00225) << "no whole number of ms";
  EXPECT_EQ(validate(ph::supervisor_parameters{.timeout = 0.001}),
            "timeout of the supervisor [s] = 0.001: expected 0.004 to 10");
  EXPECT_EQ(validate(ph::supervisor_parameters{.priority = 100}),
            "priority of the supervisor = 100: expected 0 (none) to 99");
}

}  // namespace supervisor_tests
