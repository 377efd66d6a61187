// The forces that a device can display at all: in closed form, at rest, at singular poses, along paths.
#include "../support.hpp"

#include <passive_haptics/design/undisplayable_share.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace {

namespace displayable_forces {

constexpr double right_angle = std::numbers::pi / 2, infinite = std::numeric_limits<double>::infinity(),
                 nan = std::numeric_limits<double>::quiet_NaN();

using tendon = ph::tendon_two_link<double>;
using table = ph::xy_table<double>;
using pair = ph::vector<double, 2>;

TEST(displayable, is_everything_at_rest) {
  const tendon arm;
  const pair q(0.7, 1.1), n(0.6, 0.8), limit(1, 0.5);
  const auto found = ph::displayable(arm, q, {0, 0}, n, limit);
  EXPECT_EQ(found.display, ph::display_class::exact);
  EXPECT_EQ(found.angle, 0);
  EXPECT_TRUE(found.signs.isZero(0));
  const pair per_limit = ph::force_generators(arm, q).transpose() * n;
  EXPECT_NEAR(found.max_force, per_limit.cwiseAbs().dot(limit), 1e-12);
}

TEST(displayable, is_nothing_out_of_a_wall_and_without_bound_if_no_limit_is_given) {
  const tendon arm;
  const pair q(0.7, 1.1), n(0.6, 0.8);
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
  const auto found = ph::displayable(table(), {0, 0}, {-0.6, -0.8}, {0.6, 0.8}, {1, 10});
  EXPECT_EQ(found.display, ph::display_class::exact);
  EXPECT_NEAR(found.max_force, 0.6 * 1 + 0.8 * 10, 1e-12);
  EXPECT_NEAR(found.max_approximated_force, 1 / 0.6, 1e-12);
  const auto one = ph::displayable(table(), {0, 0}, {1, -1}, {0.6, 0.8}, {1, 10});
  EXPECT_EQ(one.display, ph::display_class::approximate);
  EXPECT_EQ(one.signs, pair(1, -1));
  EXPECT_NEAR(one.angle, std::atan2(0.6, 0.8), 1e-12);
  EXPECT_NEAR(one.max_force, 0.8 * 10, 1e-12);
  EXPECT_NEAR(one.max_approximated_force, 0.8 * 10, 1e-12);
  const auto across = ph::displayable(table(), {0, 0}, {0, -1}, {0, 1}, {infinite, 2});
  EXPECT_EQ(across.max_force, 2) << "a brake that rests adds nothing, even without limit";
  EXPECT_EQ(across.max_approximated_force, 2);
}

// One brake moves the handle along its column of E: the other rests, to rounding.
TEST(displayable, knows_which_brake_rests) {
  const tendon arm;
  ph::testing::random_source random(11);
  for (int k = 0; k < 100; ++k) {
    const pair q(random.uniform(-3.0, 3.0), random.uniform(0.3, 2.8));
    const auto E = ph::brake_jacobian(arm, q);
    for (int i = 0; i < 2; ++i)
      EXPECT_EQ(ph::displayable(arm, q, -E.col(i), E.col(i)).signs, -pair::Unit(i)) << "pose " << k;
  }
}

// Two links stretched along x carry all that pulls along them. Across them the brake with less torque for its
// rate gives way.
TEST(displayable, knows_singular_poses) {
  const tendon arm;
  const auto& p = arm.parameters();
  const auto along = ph::displayable(arm, {0, 0}, {0, 1}, {1, 0}, {1, 1});
  EXPECT_EQ(along.display, ph::display_class::exact);
  EXPECT_EQ(along.max_force, infinite);
  const double arm_2 = p.length_2 / arm.transmission()(1, 1), arm_1 = p.length_1 + p.length_2 - arm_2;
  for (const double limit_2 : {1.0, 0.1}) {
    const auto across = ph::displayable(arm, {0, 0}, {0, -1}, {0, 1}, {1, limit_2});
    EXPECT_EQ(across.display, ph::display_class::exact);
    EXPECT_EQ(across.signs, pair(-1, -1));
    EXPECT_NEAR(across.max_force, std::min(1 / arm_1, limit_2 / arm_2), 1e-12);
  }
  EXPECT_TRUE(ph::displayable(arm, {0, 0}, {1, 0}, {0, 1}, {1, 1}).signs.isZero(0)) << "it cannot move so";
}

TEST(displayable, says_what_is_wrong) {
  const tendon arm;
  const pair q(0.7, 1.1), v(0, 1), n(1, 0);
  const auto outcome = [](const auto& found) {
    EXPECT_EQ(found.display, ph::display_class::none);
    EXPECT_EQ(found.max_force, 0);
    EXPECT_EQ(found.angle, right_angle);
    return found.outcome;
  };
  EXPECT_EQ(outcome(ph::displayable(arm, {nan, 0}, v, n)), ph::status::state_not_finite);
  EXPECT_EQ(outcome(ph::displayable(arm, q, {infinite, 0}, n)), ph::status::state_not_finite);
  EXPECT_EQ(outcome(ph::displayable(arm, q, v, {nan, 0})), ph::status::contact_invalid);
  EXPECT_EQ(outcome(ph::displayable(arm, q, v, {0, 0})), ph::status::contact_invalid);
  EXPECT_EQ(outcome(ph::displayable(arm, q, v, n, {nan, 1})), ph::status::parameters_invalid);
  EXPECT_EQ(outcome(ph::displayable(arm, q, v, n, {1, -1})), ph::status::parameters_invalid);
}

TEST(displayable, depends_on_no_length_of_the_normal_or_the_direction) {
  const tendon arm;
  const pair q(0.7, 1.1), limit(1, 2), n(-0.6, 0.8), v(0.28, -0.96);
  const auto expected = ph::displayable(arm, q, v, n, limit);
  EXPECT_GT(expected.max_force, 0);
  for (const double largest : {1e-320, 1e-200, 1e154, 1.7e308}) {  // of the components
    const double rounding = largest < 1e-300 ? 1e-3 : 1e-12;
    const auto as_long = [&](const pair& x) -> pair { return largest * (x / x.cwiseAbs().maxCoeff()); };
    const auto found = ph::displayable(arm, q, as_long(v), as_long(n), limit);
    EXPECT_EQ(found.outcome, ph::status::ok) << largest;
    EXPECT_NEAR(found.max_force, expected.max_force, rounding * expected.max_force) << largest;
    EXPECT_NEAR(found.angle, expected.angle, rounding) << largest;
  }
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
  EXPECT_NEAR(ph::undisplayable_share(arm, along(-1)), 0.98, 0.01);
}

TEST(undisplayable_share, counts_where_nothing_or_too_little_can_be_displayed) {
  // Along a wall for 0.3 of the path, then out of it
  const auto path = [](double u) {
    return ph::path_point<table>{{0, 0}, u < 0.3 ? pair(1, 0) : pair(0, 1), {0, 1}};
  };
  EXPECT_NEAR(ph::undisplayable_share(table(), path), 0.7, 1e-12);
  EXPECT_NEAR(ph::undisplayable_share(table(), path, {0.1, 0.2}), 0.7, 1e-12) << "however little will do";
  EXPECT_NEAR(ph::undisplayable_share(table(), path, {1, 2}, 1.9), 0.7, 1e-12);
  EXPECT_EQ(ph::undisplayable_share(table(), path, {1, 2}, 2), 1) << "2 N at most is no hold against 2 N";
  EXPECT_EQ(ph::undisplayable_share(table(), path, {1, 2}, 0, 2), 0.5) << "at 1/4 and 3/4";
  const auto lost = [](double u) { return ph::path_point<table>{{u < 0.5 ? 0 : nan, 0}, {1, 0}, {0, 1}}; };
  EXPECT_NEAR(ph::undisplayable_share(table(), lost), 0.5, 1e-12);
  EXPECT_THROW(ph::undisplayable_share(table(), path, {1, 1}, 0, -1), std::invalid_argument);
}

}  // namespace displayable_forces

}  // namespace
