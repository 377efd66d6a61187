// slow
// Sink slopes at the edge: no push, no motion, limits of 0 and without bound, singular poses, no result; in
// float.
#include <passive_haptics/design/sink_depth.hpp>
#include <passive_haptics/mechanism/models/five_bar.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include "../support.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace {

constexpr double not_at_all = std::numeric_limits<double>::infinity(),
                 no_number = std::numeric_limits<double>::quiet_NaN(),
                 denormal = std::numeric_limits<double>::denorm_min();
using sinking_table = ph::xy_table<double>;
using sinking_arm = ph::tendon_two_link<double>;
using plane = ph::vector<double, 2>;

// A slanted wall along which brake y holds up to 0.8 limit_y at once, brake x 0.6 limit_x more from 4/3 on.
double on_slanted_wall(const plane& limit, double push, const plane& direction = {0.8, -0.6}) {
  const auto found = ph::sink_slope(sinking_table(), {0, 0}, direction, {0.6, 0.8}, limit, push);
  EXPECT_EQ(found.outcome, ph::status::ok);
  return found.slope;
}

TEST(sink_slope, without_a_push_is_0) {
  for (const double push : {0.0, -0.0, -1.0, -1e308, -not_at_all}) {
    EXPECT_EQ(on_slanted_wall({1, 2}, push), 0) << push;
    EXPECT_EQ(on_slanted_wall({0, 0}, push), 0) << push;
  }
  EXPECT_EQ(on_slanted_wall({0, 0}, denormal), not_at_all) << "brakes that are off hold nothing at all";
}

TEST(sink_slope, of_limits_without_bound_and_of_a_push_without_bound) {
  EXPECT_EQ(on_slanted_wall({1, not_at_all}, 1e300), 0);
  EXPECT_NEAR(on_slanted_wall({not_at_all, 2}, 1e300), 4.0 / 3, 1e-15);
  EXPECT_NEAR(on_slanted_wall({not_at_all, 0}, not_at_all), 4.0 / 3, 1e-15);
  EXPECT_EQ(on_slanted_wall({1, 2}, not_at_all), not_at_all);
  EXPECT_NEAR(on_slanted_wall({1e308, 1e-308}, 1e307), 4.0 / 3, 1e-15);
  // Along x brake x rests in the wall's normal, however strong it is
  const auto across = ph::sink_slope(sinking_table(), {0, 0}, {1, 0}, {0, 1}, {not_at_all, 2}, 2.1);
  EXPECT_EQ(across.slope, not_at_all);
}

TEST(sink_slope, of_a_hand_that_does_not_move_along_the_wall_is_0_or_infinite) {
  const plane n(0.6, 0.8);
  for (const plane& direction : {plane(0, 0), n, plane(-n), plane(1e300 * n), plane(1e-300 * n)}) {
    EXPECT_EQ(on_slanted_wall({1, 2}, 2.19, direction), 0) << direction.transpose();
    EXPECT_EQ(on_slanted_wall({1, 2}, 2.21, direction), not_at_all) << direction.transpose();
  }
}

// Two links stretched along x. The links hold what pushes along x; along y the joint that holds less gives
// way, at every slope, since the handle cannot move along x.
TEST(sink_slope, at_a_singular_pose) {
  const ph::two_link<double> arm;
  const double l1 = arm.parameters().length_1, l2 = arm.parameters().length_2;
  const auto slope = [&](const plane& direction, const plane& normal, const plane& limit, double push) {
    const auto found = ph::sink_slope(arm, {0, 0}, direction, normal, limit, push);
    EXPECT_EQ(found.outcome, ph::status::ok);
    return found.slope;
  };
  EXPECT_EQ(slope({0, 1}, {1, 0}, {1, 1}, 1e9), 0);
  EXPECT_EQ(slope({0, 1}, {0.6, 0.8}, {1, 1}, 1e9), 0);
  const double most = std::min(1 / (l1 + l2), 0.5 / l2);
  EXPECT_EQ(slope({1, 0}, {0, 1}, {1, 0.5}, 0.999 * most), 0);
  EXPECT_EQ(slope({1, 0}, {0, 1}, {1, 0.5}, 1.001 * most), not_at_all);
  // Right beside it the closed form holds: the slopes are those of the quantile
  for (const double bend : {1e-300, 1e-17, 1e-12, 1e-8, 1e-4}) {
    const auto found = ph::sink_slope(arm, {0.3, bend}, {0, 1}, {1, 0}, {1, 1}, 1.0);
    EXPECT_EQ(found.outcome, ph::status::ok) << bend;
    EXPECT_TRUE(found.slope >= 0) << bend;
  }
}

TEST(sink_slope, says_why_there_is_none) {
  const sinking_arm arm;
  const plane q(0.7, 1.1), t(0, 1), n(1, 0), limit(1, 1);
  const auto outcome = [](const auto& found) {
    EXPECT_EQ(found.slope, not_at_all);
    return found.outcome;
  };
  EXPECT_EQ(outcome(ph::sink_slope(arm, {no_number, 0}, t, n, limit, 1)), ph::status::state_not_finite);
  EXPECT_EQ(outcome(ph::sink_slope(arm, q, {not_at_all, 0}, n, limit, 1)), ph::status::state_not_finite);
  EXPECT_EQ(outcome(ph::sink_slope(arm, q, t, {0, no_number}, limit, 1)), ph::status::contact_invalid);
  EXPECT_EQ(outcome(ph::sink_slope(arm, q, t, {0, 0}, limit, 1)), ph::status::contact_invalid);
  EXPECT_EQ(outcome(ph::sink_slope(arm, q, t, n, {no_number, 1}, 1)), ph::status::parameters_invalid);
  EXPECT_EQ(outcome(ph::sink_slope(arm, q, t, n, {1, -1}, 1)), ph::status::parameters_invalid);
  EXPECT_EQ(outcome(ph::sink_slope(arm, q, t, n, limit, no_number)), ph::status::parameters_invalid);
  ph::hybrid_brakes<sinking_arm> hybrid;
  for (const double wrong : {-1e-300, no_number}) {
    hybrid.motor_limit = {0, wrong};
    EXPECT_EQ(outcome(ph::sink_slope(arm, q, t, n, hybrid, 1)), ph::status::parameters_invalid) << wrong;
  }
  EXPECT_EQ(outcome(ph::sink_slope(ph::five_bar<double>(), {3.1, 0.0}, t, n, limit, 1)),
            ph::status::pose_undefined);
  using redundant = ph::five_bar<double, 4>;
  EXPECT_EQ(outcome(ph::sink_slope(redundant(), {3.1, 0.0}, t, n, ph::brake_vector<redundant>::Ones(), 1)),
            ph::status::pose_undefined);
}

TEST(sink_depth, without_a_result_is_infinite_and_one_sample_is_refused) {
  const sinking_arm arm;
  const auto lost = [](double u) {
    return ph::path_point<sinking_arm>{{u < 0.5 ? 0.7 : no_number, 1.1}, {0, 1}, {1, 0}};
  };
  EXPECT_EQ(ph::sink_depth(arm, lost, {1, 1}, -1), not_at_all);
  EXPECT_EQ(thrown_by([&] { ph::sink_depth(arm, lost, {1, 1}, 1, 1); }),
            "passive_haptics: samples of a sink_depth = 1, expected 2 or more: it takes the path's length "
            "from two places");
}

TEST(sink_slope, is_the_same_in_float) {
  using single = ph::tendon_two_link<float>;
  ph::testing::random_source random(9);
  int sinking = 0;
  for (int k = 0; k < 200; ++k) {
    const plane q(random.uniform(-1.0, 1.0), random.uniform(0.5, 2.5)), limit(1, 0.5),
        t = random.direction<double, 2>(), n = random.direction<double, 2>();
    const double push = random.uniform(0.1, 10.0);
    const auto slope = ph::sink_slope(sinking_arm(), q, t, n, limit, push).slope;
    const auto coarse = ph::sink_slope(single(), ph::as<float>(q), ph::as<float>(t), ph::as<float>(n),
                                       ph::as<float>(limit), static_cast<float>(push))
                            .slope;
    ASSERT_EQ(std::isfinite(slope), std::isfinite(coarse)) << "seed 9, pose " << k;
    if (!std::isfinite(slope)) continue;
    EXPECT_NEAR(coarse, slope, 1e-4 * (1 + slope * slope) / std::abs(ph::cross_in_plane(t, n)))
        << "seed 9, pose " << k;
    sinking += slope > 0;
  }
  EXPECT_GT(sinking, 30);
}

}  // namespace
