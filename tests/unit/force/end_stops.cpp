// End stops: each joint by hand, and that they take energy.
#include <passive_haptics/force/effects/end_stops.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

#include <limits>

namespace ph = passive_haptics;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(end_stops, resist_each_joint_beyond_its_limits_on_the_way_out) {
  const ph::end_stops<double, 3> stops(
      {.lower = {-1, -2, -inf}, .upper = {1, inf, 3}, .stiffness = {10, 20, 30}});
  using vector = ph::vector<double, 3>;
  EXPECT_EQ(stops.torque({0, 50, -50}, {1, 1, -1}), vector(0, 0, 0));
  EXPECT_LE((stops.torque({1.5, -2.5, 3.25}, {1, -1, 1}) - vector(-5, 10, -7.5)).norm(), 1e-14);
  EXPECT_EQ(stops.torque({1.5, -2.5, 3.25}, {-1, 1, -1}), vector(0, 0, 0));
  EXPECT_EQ(stops.torque({1.5, -2.5, 3.25}, {0, 0, 0}), vector(0, 0, 0));
  EXPECT_EQ(stops.torque({1.5, -2.5, 3.25}, {0, 0, 0}, {2, -3, 100}), vector(-2, 3, -7.5));
  EXPECT_EQ(stops.torque({1.5, -2.5, 3.25}, {0, 0, 0}, {-2, 3, -100}), vector(0, 0, 0));
}

TEST(end_stops, never_drive_a_joint) {
  ph::testing::random_source random(1985);
  const ph::end_stops<float, 2> stops({.lower = {-1, -2}, .upper = {1, 0}, .stiffness = {10, 20}});
  for (int k = 0; k < 4000; ++k) {
    const ph::vector<float, 2> q = 3 * random.normal_vector<float, 2>();
    const ph::vector<float, 2> qd(random.wide(1e-6f, 1e2f), random.wide(1e-6f, 1e2f));
    const auto t = stops.torque(q, qd);
    ASSERT_LE(t[0] * qd[0], 0);
    ASSERT_LE(t[1] * qd[1], 0);
  }
}

TEST(end_stops, of_a_nan_are_not_silent) {
  const ph::end_stops<double, 1> stops(
      {.lower = ph::vector<double, 1>(-1), .upper = ph::vector<double, 1>(1)});
  const ph::vector<double, 1> lost(nan);
  for (const double speed : {-1.0, 0.0, 1.0})
    EXPECT_TRUE(stops.torque(lost, ph::vector<double, 1>(speed)).hasNaN());
}

TEST(end_stops, say_which_limit_is_wrong) {
  using stops = ph::end_stops_parameters<double, 2>;
  EXPECT_EQ(validate(stops{}), "");
  EXPECT_EQ(validate(stops{.lower = {0, 2}, .upper = {1, 2}}),
            "lower[1] of end_stops [rad] = 2: expected less than upper[1]");
  EXPECT_EQ(validate(stops{.lower = {nan, 2}}),
            "lower[0] of end_stops [rad] = nan: expected less than upper[0]");
}

}  // namespace
