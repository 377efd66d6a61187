#include <gtest/gtest.h>
#include <passive_haptics/driver/count_unwrapper.hpp>
#include <passive_haptics/testing/random.hpp>

#include <cmath>
#include <cstdint>

namespace ph = passive_haptics;

namespace {

double wrapped(std::int64_t count, int bits) {
  return static_cast<double>(count & ((std::int64_t{1} << bits) - 1));
}

TEST(count_unwrapper, follows_a_motion_over_many_wraps_exactly) {
  for (const int bits : {8, 16, 24, 32, 48}) {
    ph::testing::random_source random(static_cast<std::uint64_t>(bits));
    ph::count_unwrapper unwrap(bits);
    const double half = std::ldexp(1.0, bits - 1);
    std::int64_t truth = static_cast<std::int64_t>(random.uniform(0.0, half));
    const double start = unwrap(wrapped(truth, bits));
    ASSERT_EQ(start, static_cast<double>(truth));
    for (int k = 0; k < 10000; ++k) {
      // Mostly one way, so that it wraps thousands of times, up to 2^52
      const auto step = static_cast<std::int64_t>(random.uniform(-0.1, 0.999) * half);
      if (static_cast<double>(truth) + half > std::ldexp(1.0, 52)) break;
      truth += step;
      ASSERT_EQ(unwrap(wrapped(truth, bits)), static_cast<double>(truth)) << bits << " bits, step " << k;
    }
  }
}

TEST(count_unwrapper, takes_signed_counters_as_unsigned_ones) {
  ph::count_unwrapper unwrap(16);
  EXPECT_EQ(unwrap(32767), 32767);
  EXPECT_EQ(unwrap(-32768), 32768);
  EXPECT_EQ(unwrap(-1), 65535);
  EXPECT_EQ(unwrap(0), 65536);
  EXPECT_EQ(unwrap(-1), 65535);
}

TEST(count_unwrapper, keeps_parts_of_counts) {
  ph::count_unwrapper unwrap(16);
  EXPECT_EQ(unwrap(65535.75), 65535.75);
  EXPECT_EQ(unwrap(0.25), 65536.25);
}

TEST(count_unwrapper, without_bits_leaves_counts_as_they_are) {
  ph::count_unwrapper unwrap;
  EXPECT_EQ(unwrap(5), 5);
  EXPECT_EQ(unwrap(-1e15), -1e15);
  EXPECT_EQ(unwrap(1e15), 1e15);
}

TEST(count_unwrapper, forgets_a_count_that_is_no_number) {
  ph::count_unwrapper unwrap(16);
  unwrap(65000);
  EXPECT_TRUE(std::isnan(unwrap(NAN)));
  EXPECT_TRUE(std::isnan(unwrap(INFINITY)));
  EXPECT_EQ(unwrap(100), 65636);
}

TEST(count_unwrapper, starts_anew) {
  ph::count_unwrapper unwrap(16);
  unwrap(65000);
  unwrap(100);
  unwrap.restart();
  EXPECT_EQ(unwrap(40000), 40000);
}

TEST(count_unwrapper, complains_of_a_width_that_no_counter_has) {
  for (const int bits : {-1, 1, 7, 49, 64})
    EXPECT_THROW(ph::count_unwrapper{bits}, std::invalid_argument) << bits;
  EXPECT_EQ(ph::check_counter_bits("counter_bits", 7),
            "counter_bits = 7, expected the counter's width, 8 to 48, or 0 if it never wraps");
}

}  // namespace
