#include "../realtime/allocations.hpp"
#include "processes.hpp"

#include <gtest/gtest.h>
#include <passive_haptics/driver/process/recorder.hpp>

#include <array>
#include <atomic>
#include <csignal>
#include <stdexcept>
#include <thread>

namespace ph = passive_haptics;

namespace {

struct record {
  std::uint64_t number, square;
};

struct seen {
  std::uint64_t count = 0, wrong = 0;
  bool closed = false;
};

struct sink {
  std::string open() { return {}; }
  void take(const record&) {}
  void rest(std::uint64_t) {}
  void close() {}
};

struct checking_sink : sink {
  explicit checking_sink(ph::shared_memory<seen>* to, std::string what = {})
      : into(to), missing(std::move(what)) {}
  ph::shared_memory<seen>* into;
  std::string missing;
  std::uint64_t expected = 0;

  std::string open() { return missing; }
  void take(const record& r) {
    if (r.number < expected || r.square != r.number * r.number) ++(*into)->wrong;
    expected = r.number + 1;
    ++(*into)->count;
  }
  void close() { (*into)->closed = true; }
};

}  // namespace

TEST(a_shared_ring, keeps_the_order_and_counts_what_does_not_fit) {
  ph::shared_ring<int, 8> ring;
  int value = 0;
  EXPECT_FALSE(ring.pop(value));
  for (int round = 0; round < 100; ++round) {
    for (int k = 0; k < 10; ++k) EXPECT_EQ(ring.push(10 * round + k), k < 8);
    for (int k = 0; k < 8; ++k) {
      ASSERT_TRUE(ring.pop(value));
      EXPECT_EQ(value, 10 * round + k);
    }
    EXPECT_FALSE(ring.pop(value));
  }
  EXPECT_EQ(ring.lost(), 200u);
}

TEST(a_shared_ring, hands_over_whole_records_between_threads) {
  ph::shared_ring<record, 64> ring;
  constexpr std::uint64_t last = 300'000;
  std::thread writer([&] {
    for (std::uint64_t n = 0; n <= last; ++n)
      while (!ring.push({n, n * n})) std::this_thread::yield();
  });
  record r{};
  for (std::uint64_t expected = 0; expected <= last; ++expected) {
    while (!ring.pop(r)) std::this_thread::yield();
    if (r.number != expected || r.square != expected * expected) {
      ADD_FAILURE() << "record " << expected << " came as " << r.number;
      break;
    }
  }
  writer.join();
}

TEST(a_recorder, writes_all_down_in_another_process) {
  ph::shared_memory<seen> written;
  ph::recorder<record, checking_sink> log(checking_sink{&written});
  ASSERT_EQ(log.start(), "");
  const pid_t process = log.pid();
  EXPECT_EQ(log.start(), "start() was called twice: the process is running; call it once");
  EXPECT_EQ(log.pid(), process);
  std::uint64_t pushed = 0;
  EXPECT_EQ(allocations_in([&] {
              for (std::uint64_t n = 0; n < 5000; ++n) pushed += log({n, n * n});
            }),
            0);
  EXPECT_EQ(pushed, 5000u);
  EXPECT_TRUE(log.stop());
  EXPECT_EQ(written->count, 5000u);
  EXPECT_TRUE(written->closed);
  EXPECT_EQ(log.lost(), 0u);
  EXPECT_EQ(written->wrong, 0u);
}

TEST(a_recorder, that_was_killed_counts_what_it_did_not_take) {
  ph::shared_memory<seen> written;
  ph::recorder<record, checking_sink, 16> log(checking_sink{&written});
  ASSERT_EQ(log.start(), "");
  kill(log.pid(), SIGKILL);
  siginfo_t ended;
  ASSERT_EQ(waitid(P_PID, static_cast<id_t>(log.pid()), &ended, WEXITED | WNOWAIT), 0);
  for (std::uint64_t n = 0; n < 20; ++n) log({n, n * n});
  EXPECT_EQ(log.lost(), 4u);
  EXPECT_FALSE(log.stop());
  EXPECT_EQ(log.lost(), 20u);
}

TEST(a_recorder, whose_sink_fails_at_the_end_tells_so) {
  struct failing : sink {
    void close() { throw std::runtime_error("the disk is full"); }
  };
  ph::recorder<record, failing> log(failing{});
  ASSERT_EQ(log.start(), "");
  log({1, 1});
  EXPECT_FALSE(log.stop());
  EXPECT_EQ(log.lost(), 0u);
}

// A disk that takes the first ten records.
struct full_disk : sink {
  explicit full_disk(ph::shared_memory<std::atomic<std::uint64_t>>* to) : told(to) {}
  ph::shared_memory<std::atomic<std::uint64_t>>* told;
  std::uint64_t taken = 0;
  void take(const record&) { ++taken; }
  void rest(std::uint64_t missing) { **told = missing; }
  std::uint64_t lost() const { return taken < 10 ? 0 : taken - 10; }
};

TEST(a_recorder, whose_sink_cannot_keep_all_counts_it_as_it_happens) {
  ph::shared_memory<std::atomic<std::uint64_t>> told;
  ph::recorder<record, full_disk> log(full_disk{&told});
  ASSERT_EQ(log.start(), "");
  for (std::uint64_t n = 0; n < 25; ++n) log({n, n});
  EXPECT_TRUE(eventually([&] { return log.lost() == 15; }));
  EXPECT_TRUE(log.stop());
  EXPECT_EQ(log.lost(), 15u);
}

TEST(a_recorder, tells_its_sink_what_did_not_fit) {
  ph::shared_memory<std::atomic<std::uint64_t>> told;
  ph::recorder<record, full_disk, 8> log(full_disk{&told});
  ASSERT_EQ(log.start(), "");
  kill(log.pid(), SIGSTOP);
  siginfo_t stopped;
  ASSERT_EQ(waitid(P_PID, static_cast<id_t>(log.pid()), &stopped, WSTOPPED | WNOWAIT), 0);
  for (std::uint64_t n = 0; n < 20; ++n) log({n, n});
  EXPECT_EQ(log.lost(), 12u);
  EXPECT_TRUE(log.stop()) << "it was woken to write the rest down";
  EXPECT_EQ(*told, 12u);
  EXPECT_EQ(log.lost(), 12u);
}

TEST(a_recorder, that_cannot_open_its_file_says_so) {
  ph::shared_memory<seen> written;
  ph::recorder<record, checking_sink> log(checking_sink{&written, "cannot write log.csv"});
  EXPECT_EQ(log.start(), "cannot write log.csv");
}
