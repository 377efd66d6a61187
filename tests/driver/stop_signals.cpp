// together
#include <gtest/gtest.h>
#include <passive_haptics/driver/stop_signals.hpp>

namespace ph = passive_haptics;

TEST(stop_signals, count_one_SIGUSR1_once) {
  ph::stop_signals signals;
  EXPECT_FALSE(signals.rearm(true));
  std::raise(SIGUSR1);
  EXPECT_TRUE(signals.rearm(true));
  EXPECT_FALSE(signals.rearm(true)) << "each fault is rearmed by a signal of its own";
  EXPECT_EQ(signals.stop(), 0);
}

TEST(stop_signals, drop_a_request_that_came_before_the_release) {
  ph::stop_signals signals;
  std::raise(SIGUSR1);
  EXPECT_FALSE(signals.rearm(false)) << "nothing is released";
  std::raise(SIGUSR1);
  EXPECT_FALSE(signals.rearm(true)) << "it waited while the program was stopped, or came with the fault";
  EXPECT_FALSE(signals.rearm(true));
  std::raise(SIGUSR1);
  EXPECT_TRUE(signals.rearm(true));
  std::raise(SIGUSR1);
  EXPECT_FALSE(signals.rearm(true)) << "another release, in the same cycle";
  std::raise(SIGUSR1);
  EXPECT_TRUE(signals.rearm(true));
}

TEST(stop_signals, stay_and_begin_anew_with_each) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    ph::stop_signals signals;
    EXPECT_EQ(signals.stop(), 0);
    std::raise(signal);
    EXPECT_EQ(signals.stop(), signal);
    EXPECT_EQ(signals.stop(), signal);
  }
}

TEST(stop_signals, leave_what_was_before) {
  static int caught = 0;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGUSR1}) {
    caught = 0;
    const auto before = std::signal(signal, [](int) { ++caught; });
    {
      const ph::stop_signals signals;
      std::raise(signal);
    }
    EXPECT_EQ(caught, 0);
    std::raise(signal);
    EXPECT_EQ(caught, 1);
    std::signal(signal, before);
  }
  EXPECT_FALSE(ph::stop_signals().rearm(true)) << "a signal to one before";
}
