// together
#include <gtest/gtest.h>
#include <passive_haptics/driver/clock.hpp>

namespace ph = passive_haptics;

static_assert(ph::LoopClock<ph::monotonic_clock>);

TEST(monotonic_clock, never_wakes_early) {
  const ph::monotonic_clock clock;
  for (const std::int64_t ahead : {-1'000'000, 0, 200'000, 2'000'000}) {
    const std::int64_t deadline = clock.now() + ahead;
    clock.sleep_until(deadline);
    EXPECT_GE(clock.now(), deadline) << "asked for " << ahead << " ns ahead";
  }
}

TEST(monotonic_clock, in_seconds_is_the_same_clock) {
  const double before = 1e-9 * static_cast<double>(ph::monotonic_clock().now());
  const double between = ph::monotonic_seconds();
  const double after = 1e-9 * static_cast<double>(ph::monotonic_clock().now());
  EXPECT_LE(before, between);
  EXPECT_LE(between, after);
}

TEST(monotonic_clock, is_never_ahead_of_its_boot_time) {
  const std::int64_t now = ph::monotonic_clock().now();
  EXPECT_LE(now, ph::monotonic_clock().boot_time());
}
