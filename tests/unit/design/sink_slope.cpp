// How steeply a hand sinks, and how deep: in closed form, at the limits of all inputs, along paths.
#include "../support.hpp"

#include <passive_haptics/design/sink_depth.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>

#include <cmath>
#include <limits>

namespace {

namespace sink_slopes {

constexpr double never = std::numeric_limits<double>::infinity(),
                 nan = std::numeric_limits<double>::quiet_NaN();
using table = ph::xy_table<double>;
using tendon = ph::tendon_two_link<double>;
using pair = ph::vector<double, 2>;

// A slanted wall: brake y pushes out with 0.8 of its limit at any slope, brake x with 0.6 from 4/3 on.
const pair n(0.6, 0.8), t(0.8, -0.6);

template <class Brakes = pair>
double slope_of(double push, const Brakes& brakes = {1, 2}, const pair& direction = t,
                const pair& normal = n) {
  const auto found = ph::sink_slope(table(), {0, 0}, direction, normal, brakes, push);
  EXPECT_EQ(found.outcome, ph::status::ok);
  return found.slope;
}

TEST(sink_slope, is_that_at_which_brakes_together_resist_the_push) {
  EXPECT_EQ(slope_of(1.6), 0) << "0.8 * 2 N are there at once";
  EXPECT_NEAR(slope_of(1.61), 4.0 / 3, 1e-15) << "and 0.6 N more if the handle does not move along x";
  EXPECT_NEAR(slope_of(2.19), 4.0 / 3, 1e-15);
  EXPECT_EQ(slope_of(2.21), never) << "0.6 + 1.6 N are all";
}

TEST(sink_slope, takes_any_length_of_direction_and_normal_and_of_the_direction_the_part_along_the_wall) {
  EXPECT_NEAR(slope_of(2, pair(1, 2), 1e-200 * t, 1e200 * n), 4.0 / 3, 1e-15);
  for (const double out : {-5.0, -1.0, 1.0, 5.0})
    EXPECT_NEAR(slope_of(2, pair(1, 2), t + out * n), 4.0 / 3, 1e-14) << out;
  for (const pair& direction : {pair(0, 0), n, pair(-n), pair(1e300 * n), pair(1e-300 * n)}) {
    EXPECT_EQ(slope_of(2.19, pair(1, 2), direction), 0) << "no way along the wall";
    EXPECT_EQ(slope_of(2.21, pair(1, 2), direction), never);
  }
}

TEST(sink_slope, of_brakes_that_are_off_or_work_one_way) {
  const auto slope = [&](const auto& change, double push) {
    ph::switchable_brakes<table> brakes;
    brakes.torque_limit = {1, 2};
    change(brakes);
    return slope_of<ph::hybrid_brakes<table>>(push, brakes);
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

TEST(sink_slope, of_pushes_and_limits_of_0_and_without_bound) {
  for (const double push : {0.0, -1.0, -never}) EXPECT_EQ(slope_of(push, pair(0, 0)), 0) << push;
  EXPECT_EQ(slope_of(std::numeric_limits<double>::denorm_min(), pair(0, 0)), never) << "all are off";
  EXPECT_EQ(slope_of(1e300, pair(1, never)), 0);
  EXPECT_NEAR(slope_of(1e300, pair(never, 2)), 4.0 / 3, 1e-15);
  EXPECT_NEAR(slope_of(never, pair(never, 0)), 4.0 / 3, 1e-15);
  EXPECT_EQ(slope_of(never), never);
  EXPECT_NEAR(slope_of(1e307, pair(1e308, 1e-308)), 4.0 / 3, 1e-15);
  EXPECT_EQ(slope_of(2.1, pair(never, 2), {1, 0}, {0, 1}), never)
      << "brake x does not turn along y, however strong it is";
}

// Two links stretched along x carry what pushes along x. Across, the brake with less torque for its rate
// gives way at every slope, since the handle cannot move along x.
TEST(sink_slope, at_a_singular_pose) {
  const tendon arm;
  const auto slope = [&](const pair& q, const pair& direction, const pair& normal, double push) {
    const auto found = ph::sink_slope(arm, q, direction, normal, pair(1, 0.1), push);
    EXPECT_EQ(found.outcome, ph::status::ok);
    return found.slope;
  };
  EXPECT_EQ(slope({0, 0}, {0, 1}, {1, 0}, 1e9), 0);
  EXPECT_EQ(slope({0, 0}, {0, 1}, {0.6, 0.8}, 1e9), 0);
  const double most = 0.1 * arm.transmission()(1, 1) / arm.parameters().length_2;
  EXPECT_EQ(slope({0, 0}, {1, 0}, {0, 1}, 0.999 * most), 0);
  EXPECT_EQ(slope({0, 0}, {1, 0}, {0, 1}, 1.001 * most), never);
  for (const double bend : {1e-300, 1e-17, 1e-12, 1e-8, 1e-4})
    EXPECT_GE(slope({0.3, bend}, {0, 1}, {1, 0}, 1), 0) << bend;
}

TEST(sink_slope, says_why_there_is_none) {
  const tendon arm;
  const pair q(0.7, 1.1), along(0, 1), out(1, 0), limit(1, 1);
  const auto outcome = [](const auto& found) {
    EXPECT_EQ(found.slope, never);
    return found.outcome;
  };
  EXPECT_EQ(outcome(ph::sink_slope(arm, {nan, 0}, along, out, limit, 1)), ph::status::state_not_finite);
  EXPECT_EQ(outcome(ph::sink_slope(arm, q, {never, 0}, out, limit, 1)), ph::status::state_not_finite);
  EXPECT_EQ(outcome(ph::sink_slope(arm, q, along, {0, 0}, limit, 1)), ph::status::contact_invalid);
  EXPECT_EQ(outcome(ph::sink_slope(arm, q, along, out, {1, -1}, 1)), ph::status::parameters_invalid);
  EXPECT_EQ(outcome(ph::sink_slope(arm, q, along, out, limit, nan)), ph::status::parameters_invalid);
  ph::hybrid_brakes<tendon> hybrid;
  for (const double wrong : {-1e-300, nan}) {
    hybrid.motor_limit = {0, wrong};
    EXPECT_EQ(outcome(ph::sink_slope(arm, q, along, out, hybrid, 1)), ph::status::parameters_invalid);
  }
}

TEST(sink_depth, is_the_slope_times_the_way) {
  const auto path = [&](double u) { return ph::path_point<table>{pair(0.3 * u * t), t, n}; };  // 0.3 m
  for (const int samples : {2, 3, 200})
    EXPECT_NEAR(ph::sink_depth(table(), path, {1, 2}, 2.0, samples), 0.3 * 4 / 3, 1e-12);
  EXPECT_EQ(ph::sink_depth(table(), path, {1, 2}, 1.5), 0);
  EXPECT_EQ(ph::sink_depth(table(), path, {1, 2}, 2.3), never);
  EXPECT_EQ(thrown_by([&] { ph::sink_depth(table(), path, {1, 2}, 1, 1); }),
            "passive_haptics: samples of a sink_depth = 1: expected 2 or more: it takes the path's length "
            "from two places");
}

// The paper's device along its wall y = 0.225 m with a push of 2 N: forth the hand is held, back it sinks.
TEST(sink_depth, of_the_papers_wall) {
  const tendon arm;
  const auto along = [&](double way) {
    return [&arm, way](double u) {
      const double x = way > 0 ? 0.045 + 0.125 * u : 0.17 - 0.125 * u;
      return ph::path_point<tendon>{arm.inverse({x, 0.225}, ph::elbow::left).q, {way, 0}, {0, -1}};
    };
  };
  EXPECT_EQ(ph::sink_depth(arm, along(1), {1, 1}, 2), 0);
  const double depth = ph::sink_depth(arm, along(-1), {1, 1}, 2);
  EXPECT_GT(depth, 0.01);
  EXPECT_LT(depth, 0.2);
}

}  // namespace sink_slopes

}  // namespace
