#include <passive_haptics/core/scalar/first_order_lag.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace ph = passive_haptics;

namespace {

TEST(first_order_lag, covers_its_share_of_the_way) {
  EXPECT_DOUBLE_EQ(ph::lag_share(0.1, 0.2), 1 - std::exp(-0.5));
  EXPECT_EQ(ph::lag_share(0.1, 0.0), 1);
  EXPECT_EQ(ph::lag_share(0.0, 0.0), 1);
  EXPECT_DOUBLE_EQ(ph::lagged(3.0, 5.0, 0.1, 0.2), 5 - 2 * std::exp(-0.5));
  for (const double dt : {HUGE_VAL, std::nan("")})
    EXPECT_EQ(ph::lagged(1e17, 0.3, dt, 0.2), 0.3) << "to the bit";
  EXPECT_EQ(ph::lagged(1e17, 0.3, 0.1, 0.0), 0.3);
  EXPECT_DOUBLE_EQ(ph::low_pass_time_constant(0.5), 1 / std::numbers::pi);
  EXPECT_EQ(ph::low_pass_time_constant(0.0), 0);
  using pair = ph::vector<double, 2>;
  ph::first_order_lag<double, 2> both(pair(0.2, 0));
  EXPECT_EQ(both.output(), pair(0, 0));
  EXPECT_NEAR((both.advance(0.1, {2, 3}) - pair(2 - 2 * std::exp(-0.5), 3)).norm(), 0, 1e-15);
  EXPECT_NEAR((both.advance(0.1, {2, 4}) - pair(2 - 2 * std::exp(-1), 4)).norm(), 0, 1e-15);
}

}  // namespace
