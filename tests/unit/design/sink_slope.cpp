// How steeply a hand sinks: on paper, and along the wall of the paper.
#include <passive_haptics/design/sink_depth.hpp>
#include <passive_haptics/design/undisplayable_share.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ph = passive_haptics;

namespace {

constexpr double never = std::numeric_limits<double>::infinity();
using V = ph::vector<double, 2>;

// Brakes along x and y, a slanted wall: brake y pushes out at any slope, brake x from 4/3 on.
struct slanted {
  ph::xy_table<double> table = ph::xy_table<double>();
  V n = {0.6, 0.8}, t = {0.8, -0.6}, limit = {1, 2};
  double slope(double push) const { return ph::sink_slope(table, {0, 0}, t, n, limit, push).slope; }
};

TEST(sink_slope, is_that_at_which_brakes_together_resist_the_push) {
  const slanted wall;
  EXPECT_EQ(wall.slope(1.59), 0) << "0.8 * 2 N are there at once";
  EXPECT_NEAR(wall.slope(1.61), 4.0 / 3, 1e-15) << "and 0.6 N more where the handle does not move along x";
  EXPECT_NEAR(wall.slope(2.19), 4.0 / 3, 1e-15);
  EXPECT_EQ(wall.slope(2.21), never) << "0.6 + 1.6 N are all";
}

TEST(sink_slope, takes_any_length_of_direction_and_normal_and_of_the_direction_the_part_along_the_wall) {
  const slanted wall;
  const auto slope = [&](const V& direction, const V& normal) {
    return ph::sink_slope(wall.table, {0, 0}, direction, normal, wall.limit, 2.0).slope;
  };
  EXPECT_NEAR(slope(1e-200 * wall.t, 1e200 * wall.n), 4.0 / 3, 1e-15);
  for (const double out : {-5.0, -1.0, 1.0, 5.0})
    EXPECT_NEAR(slope(wall.t + out * wall.n, wall.n), 4.0 / 3, 1e-14) << out;
}

TEST(sink_slope, of_brakes_that_are_off_or_work_one_way) {
  const slanted wall;
  const auto slope = [&](const auto& change, double push) {
    ph::switchable_brakes<ph::xy_table<double>> brakes;
    brakes.torque_limit = wall.limit;
    change(brakes);
    return ph::sink_slope(wall.table, {0, 0}, wall.t, wall.n, brakes, push).slope;
  };
  // Out of the wall both push with torques > 0
  EXPECT_EQ(slope([](auto& b) { b.switch_off(1); }, 0.7), never);
  EXPECT_NEAR(slope([](auto& b) { b.switch_off(1); }, 0.5), 4.0 / 3, 1e-15);
  EXPECT_EQ(slope([](auto& b) { b.switch_off(0); }, 1.5), 0);
  EXPECT_EQ(slope([](auto& b) { b.switch_off(0); }, 1.7), never);
  EXPECT_NEAR(slope([](auto& b) { b.make_positive(0); }, 2.0), 4.0 / 3, 1e-15);
  EXPECT_EQ(slope([](auto& b) { b.make_negative(0); }, 2.0), never);
  EXPECT_EQ(slope([](auto& b) { b.torque_upper[1] = 0.5; }, 0.39), 0) << "0.8 * 0.5 N";
  EXPECT_NEAR(slope([](auto& b) { b.torque_upper[1] = 0.5; }, 0.41), 4.0 / 3, 1e-15);
}

TEST(sink_depth, is_the_slope_times_the_way) {
  const slanted wall;
  using point = ph::path_point<ph::xy_table<double>>;
  const auto path = [&](double u) { return point{V(0.3 * u * wall.t), wall.t, wall.n}; };  // 0.3 m
  EXPECT_NEAR(ph::sink_depth(wall.table, path, wall.limit, 2.0), 0.3 * 4 / 3, 1e-12);
  EXPECT_NEAR(ph::sink_depth(wall.table, path, wall.limit, 2.0, 2), 0.3 * 4 / 3, 1e-12);
  EXPECT_EQ(ph::sink_depth(wall.table, path, wall.limit, 1.5), 0);
  EXPECT_EQ(ph::sink_depth(wall.table, path, wall.limit, 2.3), never);
}

// The paper's device along its wall y = 0.225 m with brakes of 1 N m and a push of 2 N: forth the hand is
// held, back it sinks where undisplayable_share finds nothing.
TEST(sink_depth, of_the_papers_wall) {
  const ph::tendon_two_link<double> arm;
  const auto along = [&](double way) {
    return [&arm, way](double u) {
      const double x = way > 0 ? 0.045 + 0.125 * u : 0.17 - 0.125 * u;
      const auto pose = arm.inverse({x, 0.225}, ph::elbow::left);
      return ph::path_point<ph::tendon_two_link<double>>{pose.q, {way, 0}, {0, -1}};
    };
  };
  EXPECT_EQ(ph::sink_depth(arm, along(1), {1, 1}, 2), 0);
  EXPECT_EQ(ph::sink_depth(arm, along(-1), {0.1, 0.1}, 20), never);
  const double depth = ph::sink_depth(arm, along(-1), {1, 1}, 2);
  EXPECT_GT(depth, 0.01);
  EXPECT_LT(depth, 0.2);
}

}  // namespace
