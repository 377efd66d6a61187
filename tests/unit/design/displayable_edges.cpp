// slow
// What can be displayed at all: at rest, at singular poses, by redundant brakes, without an answer, along
// paths.
#include <passive_haptics/design/undisplayable_share.hpp>
#include <passive_haptics/mechanism/models/five_bar.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace ph = passive_haptics;

namespace {

constexpr double quarter_turn = std::numbers::pi / 2, without_limit = std::numeric_limits<double>::infinity();

using tendon_arm = ph::tendon_two_link<double>;

// One brake moves the handle along its column of E: the other rests, to rounding.
TEST(displayable, knows_which_brake_rests) {
  const tendon_arm arm;
  ph::testing::random_source random(11);
  for (int k = 0; k < 500; ++k) {
    const ph::vector<double, 2> q(random.uniform(-3.0, 3.0), random.uniform(0.3, 2.8));
    const auto E = ph::brake_jacobian(arm, q);
    for (int i = 0; i < 2; ++i) {
      const auto found = ph::displayable(arm, q, -E.col(i), E.col(i));
      EXPECT_EQ(found.signs, (-ph::vector<double, 2>::Unit(i))) << "seed 11, pose " << k;
    }
  }
}

// Two links stretched along x: what pulls along them is held by the links, and q1 + q2 / 2 alone moves the
// handle.
TEST(displayable, knows_singular_poses) {
  const ph::two_link<double> arm;
  const double length = arm.parameters().length_1 + arm.parameters().length_2;
  const auto along = ph::displayable(arm, {0, 0}, {0, 1}, {1, 0}, {1, 1});
  EXPECT_EQ(along.display, ph::display_class::exact);
  EXPECT_EQ(along.max_force, without_limit);
  const auto across = ph::displayable(arm, {0, 0}, {0, -1}, {0, 1}, {1, 1});
  EXPECT_EQ(across.display, ph::display_class::exact);
  EXPECT_EQ(across.signs, (ph::vector<double, 2>(-1, -1)));
  // The easiest way to move across turns the joint near the hand or that at the base, whoever has less force
  const double to_elbow = arm.parameters().length_1;
  EXPECT_NEAR(across.max_force, std::min(1 / length, 1 / (length - to_elbow)), 1e-12);
  const auto weak_hand = ph::displayable(arm, {0, 0}, {0, -1}, {0, 1}, {1, 0.1});
  EXPECT_NEAR(weak_hand.max_force, 0.1 / (length - to_elbow), 1e-12);
  const auto impossible = ph::displayable(arm, {0, 0}, {1, 0}, {0, 1}, {1, 1});
  EXPECT_TRUE(impossible.signs.isZero(0));

  using redundant = ph::five_bar<double, 4>;
  const redundant pantograph;
  const auto& p = pantograph.parameters();
  const auto leg = p.proximal_1 + p.distal_1;  // a straight leg: type 1
  for (const double x : {-0.03, 0.01}) {
    const ph::vector<double, 2> handle(x, std::sqrt(leg * leg - std::pow(x + p.base_distance / 2, 2)));
    const auto pose = pantograph.inverse(handle);
    const auto found = ph::displayable(pantograph, pose.q, {1, 0}, {0, 1});
    EXPECT_TRUE(found.outcome == ph::status::ok || !ph::is_displayed(found.display));
    EXPECT_FALSE(std::isnan(found.max_force));
  }
}

// Four brakes at two legs: each with the sign of its rate, and n . F the sum of what each can do.
TEST(displayable, by_generators_adds_up_what_each_brake_resists) {
  using redundant = ph::five_bar<double, 4>;
  const redundant arm;
  const auto pose = arm.inverse({0.02, 0.18});
  const ph::vector<double, 2> v(0.3, -0.8), n(-0.6, 0.8);
  const ph::vector<double, 4> limit(1, 2, 4, 8);
  const auto found = ph::displayable(arm, pose.q, v, n, limit);
  ASSERT_EQ(found.outcome, ph::status::ok);
  const ph::matrix<double, 2, 4> G = ph::force_generators(arm, pose.q);
  double max_force = 0;
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(found.signs[i], G.col(i).dot(v) > 0 ? 1 : -1) << "brake " << i;
    max_force += limit[i] * std::max(0.0, -found.signs[i] * n.dot(G.col(i)));
  }
  EXPECT_GT(max_force, 0);
  EXPECT_NEAR(found.max_force, max_force, 1e-12 * max_force);
  EXPECT_GT(found.max_approximated_force, 0);
  EXPECT_LE(found.max_approximated_force, found.max_force);
}

TEST(displayable, depends_on_no_length_of_the_normal_or_the_direction) {
  const tendon_arm arm;
  const ph::vector<double, 2> q(0.7, 1.1), limit(1, 2), n(-0.6, 0.8), v(0.28, -0.96);
  const auto expected = ph::displayable(arm, q, v, n, limit);
  ASSERT_EQ(expected.outcome, ph::status::ok);
  EXPECT_GT(expected.max_force, 0);
  for (const double largest : {1e-320, 1e-200, 1e154, 1e200, 1e308, 1.7e308}) {  // of the components
    const double rounding = largest < 1e-300 ? 1e-3 : 1e-12;
    const auto as_long = [&](const ph::vector<double, 2>& x) -> ph::vector<double, 2> {
      return largest * (x / x.cwiseAbs().maxCoeff());
    };
    for (const auto& found :
         {ph::displayable(arm, q, v, as_long(n), limit), ph::displayable(arm, q, as_long(v), n, limit)}) {
      EXPECT_EQ(found.outcome, ph::status::ok) << largest;
      EXPECT_NEAR(found.max_force, expected.max_force, rounding * expected.max_force) << largest;
      EXPECT_NEAR(found.angle, expected.angle, rounding) << largest;
    }
  }
}

TEST(displayable, says_what_is_wrong) {
  const tendon_arm arm;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const ph::vector<double, 2> q(0.7, 1.1), v(0, 1), n(1, 0), limit(1, 1);
  const auto outcome = [](const auto& found) {
    EXPECT_EQ(found.display, ph::display_class::none);
    EXPECT_EQ(found.max_force, 0);
    EXPECT_EQ(found.angle, quarter_turn);
    return found.outcome;
  };
  EXPECT_EQ(outcome(ph::displayable(arm, {nan, 0}, v, n)), ph::status::state_not_finite);
  EXPECT_EQ(outcome(ph::displayable(arm, q, {without_limit, 0}, n)), ph::status::state_not_finite);
  EXPECT_EQ(outcome(ph::displayable(arm, q, v, {nan, 0})), ph::status::contact_invalid);
  EXPECT_EQ(outcome(ph::displayable(arm, q, v, {0, 0})), ph::status::contact_invalid);
  EXPECT_EQ(outcome(ph::displayable(arm, q, v, n, {nan, 1})), ph::status::parameters_invalid);
  EXPECT_EQ(outcome(ph::displayable(arm, q, v, n, {1, -1})), ph::status::parameters_invalid);
  using pantograph = ph::five_bar<double>;
  EXPECT_EQ(outcome(ph::displayable(pantograph(), {3.1, 0.0}, v, n)), ph::status::pose_undefined);
  using redundant = ph::five_bar<double, 4>;
  EXPECT_EQ(outcome(ph::displayable(redundant(), {3.1, 0.0}, v, n)), ph::status::pose_undefined);
}

// Two slides of which the second moves nothing, with a brake more.
struct stuck_slides {
  using scalar = double;
  static constexpr int dof = 2, task_dimension = 2, brake_count = 3;
  ph::vector<double, 2> position(const ph::vector<double, 2>& q) const { return {q[0], 0}; }
  ph::matrix<double, 2, 2> jacobian() const { return ph::matrix<double, 2, 2>{{1, 0}, {0, 0}}; }
  ph::matrix<double, 3, 2> transmission() const { return ph::matrix<double, 3, 2>{{1, 0}, {0, 1}, {1, 1}}; }
};

TEST(displayable, of_redundant_brakes_is_unknown_at_a_singular_pose) {
  const auto found = ph::displayable(stuck_slides(), {0, 0}, {1, 0}, {-1, 0}, {1, 1, 1});
  EXPECT_EQ(found.outcome, ph::status::singular_jacobian);
  EXPECT_EQ(found.display, ph::display_class::none);
  EXPECT_EQ(found.max_force, 0);
}

TEST(displayable, is_the_same_in_float) {
  using single = ph::tendon_two_link<float>;
  ph::testing::random_source random(9);
  for (int k = 0; k < 100; ++k) {
    const ph::vector<double, 2> q(random.uniform(-1.0, 1.0), random.uniform(0.5, 2.5)), limit(1, 0.5);
    const ph::vector<double, 2> v = random.direction<double, 2>(), n = random.direction<double, 2>();
    const auto found = ph::displayable(tendon_arm(), q, v, n, limit);
    const auto coarse =
        ph::displayable(single(), ph::as<float>(q), ph::as<float>(v), ph::as<float>(n), ph::as<float>(limit));
    EXPECT_NEAR(coarse.max_force, found.max_force, 1e-4 * (1 + found.max_force));
    EXPECT_NEAR(coarse.angle, found.angle, 1e-3);
  }
}

TEST(undisplayable_share, counts_where_nothing_or_too_little_can_be_displayed) {
  using table = ph::xy_table<double>;
  // Along a wall for 0.3 of the path, then out of it
  const auto path = [](double u) {
    return ph::path_point<table>{
        {0, 0}, u < 0.3 ? ph::vector<double, 2>(1, 0) : ph::vector<double, 2>(0, 1), {0, 1}};
  };
  EXPECT_NEAR(ph::undisplayable_share(table(), path), 0.7, 1e-12);
  EXPECT_NEAR(ph::undisplayable_share(table(), path, {0.1, 0.2}), 0.7, 1e-12) << "however little will do";
  EXPECT_NEAR(ph::undisplayable_share(table(), path, {1, 2}, 1.9), 0.7, 1e-12);
  EXPECT_NEAR(ph::undisplayable_share(table(), path, {1, 2}, 2.1), 1, 1e-12);
  EXPECT_EQ(ph::undisplayable_share(table(), path, {1, 2}, 2), 1) << "2 N at most is no hold against 2 N";
  EXPECT_EQ(ph::undisplayable_share(table(), path, {1, 2}, 0, 2), 0.5) << "at 1/4 and 3/4";
  const auto lost = [](double u) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    return ph::path_point<table>{{u < 0.5 ? 0 : nan, 0}, {1, 0}, {0, 1}};
  };
  EXPECT_NEAR(ph::undisplayable_share(table(), lost), 0.5, 1e-12);
}

}  // namespace
