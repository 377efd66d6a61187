#include <passive_haptics/core/range.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace {

using passive_haptics::range;

TEST(range, has_ends_that_are_in_or_out) {
  constexpr double inf = range::infinity, nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(range::anything.contains(nan));
  for (const double x : {nan, inf, -inf}) {
    for (const range& r :
         {range::finite, range::positive, range::not_negative, range::between(-1, 1), range::at_least(-1)})
      EXPECT_FALSE(r.contains(x)) << to_text(r) << x;
  }
  EXPECT_TRUE(range::not_negative.contains(0.0) && range::not_negative.contains(-0.0));
  EXPECT_FALSE(range::positive.contains(0.0));
  EXPECT_TRUE(range::positive.contains(5e-324) && range::positive.contains(1e308));
  EXPECT_TRUE(range::between(1, 2).contains(1) && range::between(1, 2).contains(2));
  EXPECT_FALSE(range::between(1, 2).contains(0) || range::between(1, 2).contains(3));
  const range endless{.lower = 0, .open_above = false};
  EXPECT_TRUE(endless.contains(inf));
  EXPECT_FALSE(endless.contains(nan));
  static_assert(range::positive.contains(1) && !range::positive.contains(0));
}

TEST(range, says_what_is_expected) {
  EXPECT_EQ(to_text(range::anything), "anything");
  EXPECT_EQ(to_text(range::finite), "a finite number");
  EXPECT_EQ(to_text(range::positive), "a finite number > 0");
  EXPECT_EQ(to_text(range::not_negative), "a finite number >= 0");
  EXPECT_EQ(to_text(range::direction), "a direction");
  EXPECT_EQ(to_text(range::between(0.004, 10)), "0.004 to 10");
  EXPECT_EQ(to_text(range::at_least(2), true), "a whole number >= 2");
  EXPECT_EQ(to_text(range{.lower = 0, .open_above = false}), "a number > 0, or inf");
  EXPECT_EQ(to_text(range{.upper = 1, .open_above = false}), "a finite number <= 1");
  EXPECT_EQ(to_text(range{.lower = 0, .upper = 3, .open_below = false}), "a finite number >= 0 and < 3");
  EXPECT_EQ(to_text(range::between(0, 99).as("0 (none) to 99")), "0 (none) to 99");
}

// In its own type, so that a bound of double does not let the next float pass
TEST(range, compares_in_the_type_of_the_value) {
  const range acute{0, std::numbers::pi / 2};
  const float right = static_cast<float>(std::numbers::pi / 2);
  EXPECT_FALSE(acute.contains(right));
  EXPECT_TRUE(acute.contains(std::nextafter(right, 0.0f)));
}

}  // namespace
