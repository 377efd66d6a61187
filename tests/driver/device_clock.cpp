// together
#include <gtest/gtest.h>
#include <passive_haptics/driver/device_clock.hpp>

#include <random>

namespace device_clock_tests {

TEST(device_clock, a_sample_that_waited_is_seen_to_be_old) {
  passive_haptics::device_clock clock;
  EXPECT_EQ(clock.to_host(5000, 100.000), 100.000);
  EXPECT_NEAR(clock.to_host(6000, 100.001), 100.001, 1e-6);
  EXPECT_NEAR(clock.to_host(7000, 100.052), 100.002, 1e-5) << "50 ms late";
  EXPECT_NEAR(clock.to_host(58000, 100.053), 100.053, 1e-4) << "in time again";
}

TEST(device_clock, no_sample_comes_from_the_future) {
  passive_haptics::device_clock clock;
  for (int k = 0; k < 100'000; ++k) {
    const double now = 7 + 1e-3 * k;
    // A device whose clock is 0.09 % fast, and jitter
    const auto device = static_cast<std::uint32_t>(1e6 * 1.0009e-3 * k - (k % 7) * 10);
    ASSERT_LE(clock.to_host(device, now), now);
  }
  // Nor where both clocks are large and the sum of offset and elapsed time is rounded up
  std::mt19937_64 random(20040627);
  std::uniform_real_distribution<double> pause(0, 3e-3), uptime(0, 1e7);
  for (int run = 0; run < 100; ++run) {
    passive_haptics::device_clock late;
    double now = uptime(random);
    auto device = static_cast<std::uint32_t>(random());
    for (int k = 0; k < 1000; ++k) {
      const double step = pause(random);
      now += step;
      device += static_cast<std::uint32_t>(1e6 * step);
      ASSERT_LE(late.to_host(device, now), now) << "run " << run << ", sample " << k;
    }
  }
}

TEST(device_clock, follows_a_clock_that_is_fast_or_slow) {
  for (const double rate : {0.9991, 1.0, 1.0009}) {
    passive_haptics::device_clock clock;
    for (int k = 0; k < 200'000; ++k) {
      const double now = 1e-3 * k;
      ASSERT_NEAR(clock.to_host(static_cast<std::uint32_t>(1e6 * rate * now), now), now, 1e-5) << rate;
    }
  }
}

TEST(device_clock, wraps_without_a_jump) {
  passive_haptics::device_clock clock;
  const std::uint32_t start = 0xFFFF'FFFF - 5000;
  for (std::uint32_t k = 0; k < 20; ++k) {
    const double now = 3 + 1e-3 * k;
    EXPECT_NEAR(clock.to_host(start + 1000 * k, now), now, 1e-6) << k;
  }
}

TEST(device_clock, a_device_that_starts_again_is_taken_up_at_once) {
  passive_haptics::device_clock clock;
  for (std::uint32_t k = 0; k < 1000; ++k) clock.to_host(1000 * k, 1e-3 * k);
  EXPECT_DOUBLE_EQ(clock.to_host(17, 3.0), 3.0);
  EXPECT_NEAR(clock.to_host(1017, 3.001), 3.001, 1e-6);
}

}  // namespace device_clock_tests
