#include <passive_haptics/driver/control_loop.hpp>
#include <passive_haptics/driver/process/recorder.hpp>
#include <passive_haptics/driver/process/supervisor.hpp>
#include <passive_haptics/driver/safe_port.hpp>
#include <passive_haptics/driver/stop_signals.hpp>

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>

namespace ph = passive_haptics;

namespace {

// A device whose analog outputs keep their last value, whoever dies.
struct outputs {
  std::atomic<double> current = 0;
  std::atomic<std::uint32_t> writes = 0, releases = 0, samples = 0;
  std::atomic<std::int64_t> released_at = 0;  // [ns]
  std::atomic<std::uint32_t> recorded = 0;
  std::atomic<bool> after_stop = false;
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
    device->current = currents[0];
    ++device->writes;
    return ph::port_status::ok;
  }
  void release() noexcept {
    device->current = 0;
    device->released_at = ph::monotonic_clock().now();
    ++device->releases;
  }
};
static_assert(ph::BrakePort<keeping_port>);

struct numbers_to_file {
  std::filesystem::path path;
  std::FILE* file = nullptr;

  std::string open() {
    file = std::fopen(path.c_str(), "w");
    return file == nullptr ? "cannot write " + path.string() : "";
  }
  void take(const std::uint32_t& number) { std::fprintf(file, "%u\n", number); }
  void rest() { std::fflush(file); }
  void close() {
    std::fputs("end\n", file);
    std::fclose(file);
  }
};

// Waits for something that happens; the time is only there to end a test that fails.
bool happens(const std::function<bool()>& what) {
  for (int k = 0; k < 20'000; ++k) {
    if (what()) return true;
    usleep(1000);
  }
  return false;
}

struct a_supervised_loop : ::testing::Test {
  ph::shared_memory<outputs> device;
  std::filesystem::path log =
      std::filesystem::temp_directory_path() / ("supervised_" + std::to_string(getpid()));
  pid_t loop = -1;

  ~a_supervised_loop() override {
    if (loop > 0) kill(loop, SIGKILL), waitpid(loop, nullptr, 0);
    std::filesystem::remove(log);
  }

  // Forks a process as brake drivers are; `each` may spoil a cycle.
  void start(const std::function<void(int)>& each = nullptr, double timeout = 0.2) {
    loop = fork();
    ASSERT_GE(loop, 0);
    if (loop == 0) _exit(drive(each, timeout));
    ASSERT_TRUE(happens([&] { return device->current == 0.5; })) << "the loop runs";
  }

  int drive(const std::function<void(int)>& each, double timeout) {
    ph::recorder<std::uint32_t, numbers_to_file> record(numbers_to_file{log});
    ph::supervisor<keeping_port> guard(keeping_port{&*device}, {.timeout = timeout});
    ph::safe_port_parameters<1, 0> p;
    p.hold_over = 10;  // of this nothing is tested here
    ph::safe_port<keeping_port> port(keeping_port{&*device}, {}, p);
    if (!record.start().empty() || !guard.start().empty() || !port.open().empty()) return 2;
    const ph::stop_signals signals;
    ph::control_loop loop_at_1_khz(
        ph::control_loop_parameters{.most_overruns = 1000000, .longest_sleep = 1e9});
    int k = 0;
    const auto report = loop_at_1_khz.run(
        [&](const ph::loop_cycle& now) {
          if (!guard.beat(now.time)) port.release({ph::fault::supervisor_lost});
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

  // Every number that the loop recorded, in order, and that the file was ended.
  void expect_all_recorded() {
    const auto ended = [&] {
      std::ifstream in(log);
      std::string line, last;
      while (std::getline(in, line)) last = line;
      return last == "end";
    };
    ASSERT_TRUE(happens(ended));
    std::ifstream in(log);
    std::uint32_t number = 0, expected = 0;
    while (in >> number) ASSERT_EQ(number, expected++);
    EXPECT_GE(expected, device->recorded);
    EXPECT_GT(expected, 0u);
  }

  int end_of_loop() {
    int status = 0;
    waitpid(loop, &status, 0);
    loop = -1;
    return status;
  }
};

int* volatile nowhere = nullptr;

class a_signal : public a_supervised_loop, public ::testing::WithParamInterface<int> {};

}  // namespace

TEST_P(a_signal, that_kills_the_loop_leaves_no_current_and_no_record_behind) {
  start();
  const std::int64_t killed = ph::monotonic_clock().now();
  kill(loop, GetParam());
  const int status = end_of_loop();
  EXPECT_FALSE(WIFEXITED(status) && WEXITSTATUS(status) == 0);  // a sanitizer ends it in its own way
  EXPECT_TRUE(happens([&] { return device->current == 0; }));
  std::printf("0 A %.1f ms after %s\n", 1e-6 * static_cast<double>(device->released_at - killed),
              strsignal(GetParam()));
  expect_all_recorded();
}
INSTANTIATE_TEST_SUITE_P(each, a_signal, ::testing::Values(SIGKILL, SIGSEGV, SIGABRT, SIGBUS, SIGQUIT),
                         [](const auto& one) { return std::string("SIG").append(sigabbrev_np(one.param)); });

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

TEST_F(a_supervised_loop, that_crashes_by_itself_leaves_no_current) {
  start([](int k) {
    if (k == 50) *nowhere = 1;
  });
  const int status = end_of_loop();
  EXPECT_FALSE(WIFEXITED(status) && WEXITSTATUS(status) == 0);  // a sanitizer ends it in its own way
  EXPECT_TRUE(happens([&] { return device->current == 0; }));
  expect_all_recorded();
}

TEST_F(a_supervised_loop, whose_law_throws_leaves_no_current) {
  start([](int k) {
    if (k == 50) throw std::runtime_error("a law");
  });
  const int status = end_of_loop();
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 1);
  EXPECT_EQ(device->current, 0);
  expect_all_recorded();
}

TEST_F(a_supervised_loop, that_hangs_is_released) {
  start([](int k) {
    while (k == 50) usleep(1000);
  });
  EXPECT_TRUE(happens([&] { return device->current == 0; }));
  EXPECT_EQ(kill(loop, 0), 0) << "the loop is still there";
}

TEST_F(a_supervised_loop, that_is_stopped_is_released_and_stays_so_when_it_goes_on) {
  start();
  kill(loop, SIGSTOP);
  EXPECT_TRUE(happens([&] { return device->current == 0; }));
  kill(loop, SIGCONT);
  EXPECT_TRUE(happens([&] { return device->after_stop.load(); })) << "the loop releases its own port";
  for (int k = 0; k < 50; ++k) {
    usleep(1000);
    ASSERT_EQ(device->current, 0);
  }
  kill(loop, SIGINT);
  end_of_loop();
  expect_all_recorded();
}

TEST_F(a_supervised_loop, does_not_go_on_without_its_supervisor) {
  ph::supervisor<keeping_port> guard(keeping_port{&*device});
  ASSERT_EQ(guard.start(), "");
  EXPECT_TRUE(guard.beat(1));
  EXPECT_TRUE(guard.beat(1.05));
  EXPECT_TRUE(guard.alive());
  kill(guard.pid(), SIGKILL);
  usleep(20'000);
  guard.beat(2);
  EXPECT_FALSE(guard.beat(2.11));
  EXPECT_FALSE(guard.alive()) << "nothing to rearm with";
}

TEST_F(a_supervised_loop, gives_a_supervisor_with_a_long_timeout_the_time_to_look) {
  ph::supervisor<keeping_port> guard(keeping_port{&*device}, {.timeout = 10});
  ASSERT_EQ(guard.start(), "");
  EXPECT_TRUE(guard.beat(1));
  EXPECT_TRUE(guard.beat(3)) << "it looks every 2.5 s";
  EXPECT_FALSE(guard.beat(11.1));
}

TEST_F(a_supervised_loop, can_be_rearmed_after_it_was_released) {
  ph::supervisor<keeping_port> guard(keeping_port{&*device}, {.timeout = 0.05});
  ASSERT_EQ(guard.start(), "");
  usleep(100'000);
  EXPECT_FALSE(guard.released()) << "the first heartbeat starts the watch";
  EXPECT_TRUE(guard.beat(1));
  EXPECT_TRUE(happens([&] { return guard.released(); }));
  EXPECT_FALSE(guard.beat(1.01));
  EXPECT_GE(device->releases, 1u);
  guard.rearm();
  EXPECT_TRUE(guard.beat(1.02));
  device->current = 1;
  guard.stop();
  EXPECT_EQ(device->current, 0) << "released once more at its end";
}

TEST(a_supervisor, that_finds_no_device_says_so) {
  ph::shared_memory<outputs> device;
  ph::supervisor<keeping_port> guard(keeping_port{&*device, "no /dev/comedi7"});
  EXPECT_EQ(guard.start(), "no /dev/comedi7");
  EXPECT_LE(guard.pid(), 0);
}

TEST(a_supervisor, checks_its_parameters) {
  EXPECT_EQ(validate(ph::supervisor_parameters{}), "");
  EXPECT_EQ(validate(ph::supervisor_parameters{.timeout = 0.001}),
            "timeout of the supervisor [s] = 0.001, expected 0.004 to 10");
  EXPECT_EQ(validate(ph::supervisor_parameters{.priority = 100}),
            "priority of the supervisor = 100, expected 0 (none) to 99");
}
