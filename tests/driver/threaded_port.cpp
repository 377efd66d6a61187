// A port whose transfers may wait, and a loop beside it that does not, whatever the port does.
#include "../realtime/allocations.hpp"
#include "eventually.hpp"

#include <gtest/gtest.h>
#include <passive_haptics/driver/thread/threaded_port.hpp>

#include <sys/resource.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <mutex>
#include <thread>
#include <vector>

namespace {

namespace ph = passive_haptics;
using ph::port_status;
using currents = ph::brake_currents<2>;

// What a device has heard and what it will answer.
struct device {
  std::timed_mutex line;              // who holds it keeps the port waiting in read()
  std::atomic<bool> is_read = false;  // while the line is held: whether the port waits for it
  std::mutex guard;                   // of all below
  std::vector<currents> heard;
  int releases = 0;
  std::string missing;
  ph::port_sample<2> sample;
  std::vector<port_status> reads;  // then no_sample
  port_status write = port_status::ok;

  template <class F>
  auto guarded(const F& f) {
    const std::lock_guard hold(guard);
    return f();
  }
  void say(port_status status, std::uint32_t sequence) {
    const std::lock_guard hold(guard);
    sample.sequence = sequence;
    reads.push_back(status);
  }
  std::size_t unread() {
    return guarded([&] { return reads.size(); });
  }
  std::vector<currents> all_heard() {
    return guarded([&] { return heard; });
  }
  int all_releases() {
    return guarded([&] { return releases; });
  }
  bool heard_last(const currents& c) {
    return guarded([&] { return !heard.empty() && heard.back() == c; });
  }
  // The answer to a port, once the line is free.
  port_status answer(ph::port_sample<2>& to) {
    is_read = true;
    const std::lock_guard wait(line);
    is_read = false;
    const std::lock_guard hold(guard);
    if (reads.empty()) return port_status::no_sample;
    const port_status status = reads.front();
    reads.erase(reads.begin());
    if (status == port_status::ok) to = sample;
    return status;
  }
};

// A port that waits wherever it can.
struct slow_port {
  static constexpr int encoder_count = 2, brake_count = 2;
  device* d;

  explicit slow_port(device& of) : d(&of) {}
  slow_port(slow_port&& other) noexcept : d(std::exchange(other.d, nullptr)) {}
  ~slow_port() {
    if (d != nullptr) release();
  }
  std::string open() { return d->missing; }
  port_status read(ph::port_sample<2>& sample) noexcept { return d->answer(sample); }
  port_status write(const currents& c) noexcept {
    const std::lock_guard hold(d->guard);
    d->heard.push_back(c);
    return d->write;
  }
  void release() noexcept {
    const std::lock_guard hold(d->guard);
    ++d->releases;
    d->heard.push_back({});
  }
  int counter_bits() const noexcept { return 24; }
};

using port = ph::threaded_port<slow_port>;
static_assert(ph::BrakePort<port>);

struct threaded_port : ::testing::Test {
  device d;
  ph::port_sample<2> last;

  // What is said, once the port has heard all of it.
  port_status read_of(port& p, const std::vector<port_status>& said) {
    std::uint32_t sequence = 100;
    d.line.lock();
    for (const port_status s : said) d.say(s, ++sequence);
    d.line.unlock();
    EXPECT_TRUE(eventually([&] { return d.unread() == 0; }));
    // The last of them has arrived when the port has come round again
    const std::size_t before = d.all_heard().size();
    p.write({});
    EXPECT_TRUE(eventually([&] { return d.all_heard().size() > before; }));
    return p.read(last);
  }

  // The port waits in read(), after the device has heard so many currents, until the lock is let go.
  std::unique_lock<std::timed_mutex> waiting_after(std::size_t heard) {
    EXPECT_TRUE(eventually([&] { return d.all_heard().size() == heard; }));
    std::unique_lock line(d.line);
    EXPECT_TRUE(eventually([&] { return d.is_read.load(); }));
    return line;
  }
};

TEST_F(threaded_port, is_the_port_itself_until_that_is_open) {
  d.missing = "no such device";
  port p{slow_port(d)};
  EXPECT_EQ(p.open(), "no such device");
  d.say(port_status::failed, 1);
  EXPECT_EQ(p.read(last), port_status::failed);
  EXPECT_EQ(p.write({1, 2}), port_status::ok);
  p.release();
  EXPECT_EQ(d.all_heard(), (std::vector<currents>{{1, 2}, {}})) << "at once, by no thread";
  EXPECT_EQ(p.counter_bits(), 24);
}

TEST_F(threaded_port, a_loop_goes_on_while_the_port_waits) {
  port p{slow_port(d)};
  ASSERT_EQ(p.open(), "");
  EXPECT_EQ(p.write({1, 1}), port_status::ok);
  std::unique_lock wait = waiting_after(1);
  // The port waits for as long as this takes: were one call to wait for it, the test would never end
  EXPECT_EQ(p.write({2, 2}), port_status::ok) << "those before have gone out";
  for (int k = 0; k < 10'000; ++k) {
    EXPECT_EQ(p.read(last), port_status::no_sample);
    EXPECT_EQ(p.write({3, 3.0 + k}), port_status::no_sample) << "those before have not";
  }
  p.release();
  EXPECT_EQ(p.write({4, 4}), port_status::no_sample);
  wait.unlock();
  ASSERT_TRUE(eventually([&] { return d.all_heard().size() == 3; }));
  EXPECT_EQ(d.all_heard(), (std::vector<currents>{{1, 1}, {}, {4, 4}}))
      << "the newest alone, after the release";
  EXPECT_TRUE(eventually([&] { return p.write({5, 5}) == port_status::ok; }));
}

TEST_F(threaded_port, a_release_takes_along_what_was_written_before_it) {
  port p{slow_port(d)};
  ASSERT_EQ(p.open(), "");
  p.write({1, 1});
  std::unique_lock wait = waiting_after(1);
  p.write({2, 2});
  p.release();
  wait.unlock();
  ASSERT_TRUE(eventually([&] { return d.all_releases() == 1; }));
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_EQ(d.all_heard(), (std::vector<currents>{{1, 1}, {}}))
      << "each once: a loop that hangs feeds no watchdog";
}

TEST_F(threaded_port, reads_the_newest_of_all_that_came) {
  port p{slow_port(d)};
  ASSERT_EQ(p.open(), "");
  constexpr auto ok = port_status::ok, none = port_status::no_sample, bad = port_status::bad_sample,
                 failed = port_status::failed;
  EXPECT_EQ(read_of(p, {ok, ok, ok}), ok);
  EXPECT_EQ(p.read(last), none);
  EXPECT_EQ(read_of(p, {bad}), bad);
  EXPECT_EQ(p.read(last), none);
  EXPECT_EQ(read_of(p, {bad, ok, bad}), ok) << "a good one came with them";
  EXPECT_EQ(p.read(last), none);
  EXPECT_EQ(read_of(p, {failed, ok}), ok) << "the newest counts";
  EXPECT_EQ(read_of(p, {ok, failed, none}), failed);
  EXPECT_EQ(p.read(last), failed) << "until the port says otherwise";
  EXPECT_EQ(read_of(p, {ok}), ok);
}

TEST_F(threaded_port, tells_how_a_write_ended_with_the_next) {
  port p{slow_port(d)};
  ASSERT_EQ(p.open(), "");
  for (const port_status s : {port_status::no_sample, port_status::failed, port_status::ok}) {
    d.guarded([&] { d.write = s; });
    const std::size_t before = d.all_heard().size();
    p.write({1, 1});
    ASSERT_TRUE(eventually([&] { return d.all_heard().size() > before; }));
    EXPECT_TRUE(eventually([&] { return p.write({1, 1}) == s; }));
  }
}

// A port without a destructor: nothing but the thread can carry out the release.
struct plain_port {
  static constexpr int encoder_count = 1, brake_count = 1;
  std::atomic<double>* current;
  std::string open() { return {}; }
  port_status read(ph::port_sample<1>&) noexcept { return port_status::no_sample; }
  port_status write(const ph::brake_currents<1>& c) noexcept {
    *current = c[0];
    return port_status::ok;
  }
  void release() noexcept { *current = 0; }
};

TEST_F(threaded_port, carries_out_what_was_ordered_before_its_end) {
  for (const bool released : {false, true})
    for (int k = 0; k < 50; ++k) {
      std::atomic<double> current = 0;
      {
        ph::threaded_port<plain_port> p{plain_port{&current}};
        ASSERT_EQ(p.open(), "");
        p.write({0.8});
        ASSERT_TRUE(eventually([&] { return current == 0.8; }));
        if (released) p.release();
      }
      ASSERT_EQ(current, 0) << "round " << k;
    }
}

// The end waits for it so long as is said, then leaves the port to its thread, which releases when it can.
TEST_F(threaded_port, whose_read_never_returns_ends_all_the_same) {
  std::unique_lock<std::timed_mutex> line;
  {
    port p{slow_port(d)};
    ASSERT_EQ(p.open(), "");
    p.write({1, 1});
    line = waiting_after(1);
  }
  EXPECT_EQ(d.all_releases(), 0) << "the read still waits";
  line.unlock();
  EXPECT_TRUE(eventually([&] { return d.all_releases() == 2; })) << "and the port is gone";
}

volatile std::sig_atomic_t handled = 0;
port* released_by_a_signal = nullptr;

TEST_F(threaded_port, may_be_released_in_a_signal_handler_and_by_another_thread) {
  port p{slow_port(d)};
  ASSERT_EQ(p.open(), "");
  released_by_a_signal = &p;
  struct sigaction act{}, before{};
  act.sa_handler = [](int) {
    released_by_a_signal->release();
    handled = handled + 1;
  };
  sigaction(SIGUSR2, &act, &before);
  std::atomic<bool> ended{false};
  const pthread_t loop = pthread_self();
  std::thread other([&] {
    for (int k = 0; k < 200; ++k) {
      pthread_kill(loop, SIGUSR2);
      p.release();
      std::this_thread::sleep_for(std::chrono::microseconds(50));
    }
    ended = true;
  });
  while (!ended) {
    p.write({1, 1});
    p.read(last);
  }
  other.join();
  sigaction(SIGUSR2, &before, nullptr);
  EXPECT_GT(handled, 0);
  const int so_far = d.all_releases();
  p.release();
  EXPECT_TRUE(eventually([&] { return d.all_releases() > so_far && d.heard_last({}); }));
}

TEST_F(threaded_port, allocates_nothing_and_gives_up_no_processor) {
  d.heard.reserve(1'000'000);  // who takes memory for it keeps all threads of the process waiting
  port p{slow_port(d)};
  ASSERT_EQ(p.open(), "");
  const auto cycles = [&](int count) {
    for (int k = 0; k < count; ++k) {
      p.read(last);
      p.write({1, 1});
      if (k % 100 == 0) p.release();
    }
  };
  // A page fault may wait for a lock of the kernel; a port that waits does so in every round
  long least = 1;
  for (int round = 0; round < 10 && least > 0; ++round) {
    rusage before{}, after{};
    getrusage(RUSAGE_THREAD, &before);
    EXPECT_EQ(allocations_in([&] { cycles(100'000); }), 0);
    getrusage(RUSAGE_THREAD, &after);
    least = after.ru_nvcsw - before.ru_nvcsw;
  }
  EXPECT_EQ(least, 0);
}

// A number in many places, so that a torn value is seen.
TEST(mailbox, hands_over_the_newest_whole) {
  using copies = std::array<std::uint64_t, 500>;
  ph::mailbox<copies> box;
  copies got{};
  EXPECT_FALSE(box.take(got));
  constexpr std::uint64_t last = 50'000;
  std::thread puts([&] {
    copies all;
    for (std::uint64_t k = 1; k <= last; ++k) {
      all.fill(k);
      box.put(all);
    }
  });
  std::uint64_t before = 0, torn = 0, old = 0;
  const double end = ph::monotonic_seconds() + 20;
  while (before < last && ph::monotonic_seconds() < end) {
    if (!box.take(got)) continue;
    for (const std::uint64_t one : got) torn += one != got[0];
    old += got[0] <= before;
    before = got[0];
  }
  puts.join();
  EXPECT_EQ(before, last);
  EXPECT_EQ(torn, 0u);
  EXPECT_EQ(old, 0u);
  EXPECT_FALSE(box.take(got));
}

struct slow_sensor {
  static constexpr int channel_count = 2;
  device* d;
  std::string open() { return d->missing; }
  port_status read(ph::port_sample<2>& sample) noexcept { return d->answer(sample); }
};
static_assert(ph::ForceSensor<ph::threaded_sensor<slow_sensor>>);

TEST(threaded_sensor, reads_what_came_and_does_not_wait) {
  device d;
  ph::threaded_sensor<slow_sensor> s(slow_sensor{&d});
  d.missing = "no sensor there";
  EXPECT_EQ(s.open(), "no sensor there");
  d.missing = "";
  ASSERT_EQ(s.open(), "");
  ph::port_sample<2> last;
  {
    const std::lock_guard wait(d.line);
    for (int k = 0; k < 1000; ++k) EXPECT_EQ(s.read(last), port_status::no_sample);
    d.say(port_status::ok, 7);
  }
  EXPECT_TRUE(eventually([&] { return s.read(last) == port_status::ok; }));
  EXPECT_EQ(last.sequence, 7u);
}

TEST(polling_thread, looks_from_start_to_stop_with_a_pause_a_small_stack_and_no_signals) {
  struct counting_look {
    std::atomic<int> looks = 0, signals = 0;
    std::atomic<std::size_t> stack = 0;
    void operator()() noexcept {
      sigset_t masked;
      pthread_sigmask(SIG_SETMASK, nullptr, &masked);
      for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGALRM})
        signals += sigismember(&masked, signal) == 0;
      pthread_attr_t attributes;
      pthread_getattr_np(pthread_self(), &attributes);
      std::size_t size = 0;
      pthread_attr_getstacksize(&attributes, &size);
      pthread_attr_destroy(&attributes);
      stack = size;
      ++looks;
    }
  };
  ph::polling_thread<counting_look> thread({.pause = 0.05});
  thread.stop();
  EXPECT_FALSE(thread.runs());
  const double start = ph::monotonic_seconds();
  ASSERT_EQ(thread.start(), "");
  EXPECT_TRUE(thread.runs());
  EXPECT_TRUE(eventually([&] { return thread->looks == 2; }));
  EXPECT_GE(ph::monotonic_seconds(), start + 0.05);
  EXPECT_TRUE(thread.stop());
  const int looks = thread->looks;
  EXPECT_LE(looks, 2 + (ph::monotonic_seconds() - start) / 0.05) << "one more at the end";
  EXPECT_FALSE(thread.runs());
  EXPECT_TRUE(thread.stop());
  EXPECT_EQ(thread->looks, looks);
  EXPECT_EQ(thread->signals, 0);
  EXPECT_EQ(thread->stack, 1u << 20);
}

TEST(polling_parameters, are_checked_by_name) {
  EXPECT_EQ(validate(ph::polling_parameters()), "");
  EXPECT_THROW(ph::threaded_sensor<slow_sensor>(slow_sensor{nullptr}, {.pause = 0}), std::invalid_argument);
}

}  // namespace
