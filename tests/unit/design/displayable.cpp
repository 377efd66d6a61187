// What can be displayed at all: on paper, and along the wall of the paper.
#include <passive_haptics/design/undisplayable_share.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace ph = passive_haptics;

namespace {

constexpr double right_angle = std::numbers::pi / 2, infinite = std::numeric_limits<double>::infinity();

using tendon = ph::tendon_two_link<double>;

TEST(displayable, takes_any_length_of_direction_and_normal) {
  const tendon arm;
  const ph::vector<double, 2> q(0.7, 1.1), v(0.3, -0.8), n(0.6, 0.8), limit(1, 0.5);
  const auto one = ph::displayable(arm, q, v, n, limit);
  const auto other = ph::displayable(arm, q, 1e200 * v, 1e-200 * n, limit);
  EXPECT_EQ(one.signs, other.signs);
  EXPECT_DOUBLE_EQ(one.max_force, other.max_force);
  EXPECT_NEAR(one.angle, other.angle, 1e-12);
}

TEST(displayable, is_everything_at_rest) {
  const tendon arm;
  const ph::vector<double, 2> q(0.7, 1.1), n(0.6, 0.8), limit(1, 0.5);
  const auto found = ph::displayable(arm, q, {0, 0}, n, limit);
  EXPECT_EQ(found.display, ph::display_class::exact);
  EXPECT_EQ(found.angle, 0);
  EXPECT_TRUE(found.signs.isZero(0));
  const ph::vector<double, 2> per_limit = ph::force_generators(arm, q).transpose() * n;
  EXPECT_NEAR(found.max_force, per_limit.cwiseAbs().dot(limit), 1e-12);
}

TEST(displayable, is_nothing_out_of_a_wall_and_without_bound_where_no_limit_is_given) {
  const tendon arm;
  const ph::vector<double, 2> q(0.7, 1.1), n(0.6, 0.8);
  const auto out = ph::displayable(arm, q, n, n), in = ph::displayable(arm, q, -n, n);
  EXPECT_EQ(out.display, ph::display_class::none);
  EXPECT_EQ(out.max_force, 0);
  EXPECT_EQ(out.max_approximated_force, 0);
  EXPECT_EQ(out.angle, right_angle);
  EXPECT_TRUE(ph::is_displayed(in.display));
  EXPECT_EQ(in.max_force, infinite);
  EXPECT_EQ(in.max_approximated_force, infinite);
  const auto released = ph::displayable(arm, q, -n, n, {0, 0});
  EXPECT_EQ(released.display, ph::display_class::none);
  EXPECT_EQ(released.max_force, 0);
}

TEST(displayable, is_limited_by_the_first_brake_that_gives_way) {
  const ph::xy_table<double> table;
  const auto found = ph::displayable(table, {0, 0}, {-0.6, -0.8}, {0.6, 0.8}, {1, 10});
  EXPECT_EQ(found.display, ph::display_class::exact);
  EXPECT_NEAR(found.max_force, 0.6 * 1 + 0.8 * 10, 1e-12);
  EXPECT_NEAR(found.max_approximated_force, 1 / 0.6, 1e-12);
  const auto one = ph::displayable(table, {0, 0}, {1, -1}, {0.6, 0.8}, {1, 10});
  EXPECT_EQ(one.display, ph::display_class::approximate);
  EXPECT_EQ(one.signs, (ph::vector<double, 2>(1, -1)));
  EXPECT_NEAR(one.angle, std::atan2(0.6, 0.8), 1e-12);
  EXPECT_NEAR(one.max_force, 0.8 * 10, 1e-12);
  EXPECT_NEAR(one.max_approximated_force, 0.8 * 10, 1e-12);
  const auto across = ph::displayable(table, {0, 0}, {0, -1}, {0, 1}, {infinite, 2});
  EXPECT_EQ(across.max_force, 2) << "a brake that rests adds nothing, without limit as well";
  EXPECT_EQ(across.max_approximated_force, 2);
}

// ---- along paths

// The paper's device along its wall y = 0.225 m: forth always something, back hardly ever anything.
TEST(undisplayable_share, of_the_papers_wall) {
  const tendon arm;
  const auto along = [&](double way) {
    return [&arm, way](double u) {
      const auto pose = arm.inverse({0.045 + 0.125 * u, 0.225}, ph::elbow::left);
      return ph::path_point<tendon>{pose.q, {way, 0}, {0, -1}};
    };
  };
  EXPECT_EQ(ph::undisplayable_share(arm, along(1)), 0);
  EXPECT_EQ(ph::undisplayable_share(arm, along(1), {1, 1}, 4), 0);
  EXPECT_NEAR(ph::undisplayable_share(arm, along(-1)), 0.98, 0.01);
  EXPECT_THROW(ph::undisplayable_share(arm, along(1), {1, 1}, 0, -1), std::invalid_argument);
}

}  // namespace
