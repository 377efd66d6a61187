// Inverse kinematics of the library's mechanisms.
#include "../support.hpp"

#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace {

constexpr ph::elbow elbows[] = {ph::elbow::left, ph::elbow::right};

template <class T>
struct inverse_kinematics : ::testing::Test {
  using point = ph::vector<T, 2>;
  // Equal links, and the longer one first and last.
  static std::vector<ph::two_link<T>> arms() {
    std::vector<ph::two_link<T>> all;
    for (const auto& [l1, l2] : {std::pair{0.15, 0.15}, {0.3, 0.1}, {0.1, 0.3}}) {
      all.emplace_back(
          ph::two_link_parameters<T>{.length_1 = static_cast<T>(l1), .length_2 = static_cast<T>(l2)});
    }
    return all;
  }
  static T longest(const ph::two_link<T>& arm) {
    return arm.parameters().length_1 + arm.parameters().length_2;
  }
  static T shortest(const ph::two_link<T>& arm) {
    return std::abs(arm.parameters().length_1 - arm.parameters().length_2);
  }
  static point elbow_of(const ph::two_link<T>& arm, const point& q) {
    return arm.parameters().length_1 * point(std::cos(q[0]), std::sin(q[0]));
  }
};
TYPED_TEST_SUITE(inverse_kinematics, scalars);

TYPED_TEST(inverse_kinematics, reaches_every_point_of_the_workspace_with_the_elbow_on_its_side) {
  using T = TypeParam;
  ph::testing::random_source random(5);
  for (const auto& arm : this->arms()) {
    for (int k = 0; k < 300; ++k) {
      // A third of the points are close to the rim, a third close to the hole
      const T reach = this->longest(arm) - this->shortest(arm);
      const T near = random.positive(T(1e-5), T(0.4)) * reach;
      const T r = k % 3 == 0   ? this->longest(arm) - near
                  : k % 3 == 1 ? this->shortest(arm) + near
                               : random.uniform(this->shortest(arm) + T(1e-3), this->longest(arm) - T(1e-3));
      const ph::vector<T, 2> x = r * random.direction<T, 2>();
      for (const ph::elbow side : elbows) {
        SCOPED_TRACE(::testing::Message() << "seed 5, x = " << x.transpose());
        const auto pose = arm.inverse(x, side);
        EXPECT_EQ(pose.outcome, ph::status::ok);
        expect_near(arm.position(pose.q), x, static_cast<double>(this->longest(arm)));
        EXPECT_EQ(pose.q[1] <= 0, side == ph::elbow::left);
        const ph::vector<T, 2> e = this->elbow_of(arm, pose.q);
        EXPECT_EQ(x[0] * e[1] - x[1] * e[0] > 0, side == ph::elbow::left);
      }
    }
  }
}

TYPED_TEST(inverse_kinematics, beyond_reach_stretches_towards_the_point) {
  using T = TypeParam;
  for (const auto& arm : this->arms()) {
    for (const T far : {T(1.001), T(3), T(1e10), std::numeric_limits<T>::max() / 2}) {
      const ph::vector<T, 2> direction(T(-0.6), T(0.8));
      for (const ph::elbow side : elbows) {
        const auto pose = arm.inverse(far * this->longest(arm) * direction, side);
        EXPECT_EQ(pose.outcome, ph::status::out_of_reach) << "at " << far << " times the reach";
        expect_near(arm.position(pose.q), ph::vector<T, 2>(this->longest(arm) * direction), 1);
      }
    }
  }
}

TYPED_TEST(inverse_kinematics, inside_the_hole_folds_towards_the_point) {
  using T = TypeParam;
  for (const auto& arm : this->arms()) {
    if (this->shortest(arm) == T(0)) continue;
    const ph::vector<T, 2> direction(T(0.6), T(-0.8));
    const auto pose = arm.inverse(T(0.9) * this->shortest(arm) * direction, ph::elbow::right);
    EXPECT_EQ(pose.outcome, ph::status::out_of_reach);
    expect_near(arm.position(pose.q), ph::vector<T, 2>(this->shortest(arm) * direction), 1);
  }
}

TYPED_TEST(inverse_kinematics, straight_is_reached_and_singular) {
  using T = TypeParam;
  const ph::two_link<T> arm(ph::two_link_parameters<T>{.length_1 = 1, .length_2 = T(0.5)});
  for (const ph::elbow side : elbows) {
    const auto straight = arm.inverse({0, T(1.5)}, side);
    EXPECT_EQ(straight.outcome, ph::status::ok);
    EXPECT_EQ(straight.q[1], T(0));
    EXPECT_NEAR(straight.q[0], std::numbers::pi_v<T> / 2, ph::rounding_tolerance<T>(4));
    const auto folded = arm.inverse({0, T(0.5)}, side);
    EXPECT_EQ(folded.outcome, ph::status::ok);
    EXPECT_NEAR(std::abs(folded.q[1]), std::numbers::pi_v<T>, ph::rounding_tolerance<T>(4));
  }
}

TYPED_TEST(inverse_kinematics, handle_on_the_base_is_reached_by_equal_links_only) {
  using T = TypeParam;
  for (const auto& arm : this->arms()) {
    for (const ph::elbow side : elbows) {
      const auto pose = arm.inverse({0, 0}, side);
      EXPECT_EQ(pose.outcome, this->shortest(arm) == T(0) ? ph::status::ok : ph::status::out_of_reach);
      EXPECT_NEAR(arm.position(pose.q).norm(), this->shortest(arm), ph::rounding_tolerance<T>(4));
    }
  }
}

TYPED_TEST(inverse_kinematics, points_that_are_not_finite_give_a_status_and_no_pose) {
  using T = TypeParam;
  for (const T bad : {std::numeric_limits<T>::quiet_NaN(), std::numeric_limits<T>::infinity(),
                      -std::numeric_limits<T>::infinity()}) {
    for (const ph::vector<T, 2>& x : {ph::vector<T, 2>(bad, T(0.1)), ph::vector<T, 2>(T(0.1), bad)}) {
      const auto pose = ph::tendon_two_link<T>().inverse(x, ph::elbow::left);
      EXPECT_EQ(pose.outcome, ph::status::state_not_finite);
      EXPECT_TRUE(pose.q.array().isNaN().all()) << pose.q.transpose();
      EXPECT_EQ(ph::xy_table<T>().inverse(x).outcome, ph::status::state_not_finite);
    }
  }
}

TYPED_TEST(inverse_kinematics, xy_table_reaches_everything) {
  const ph::vector<TypeParam, 2> x(-3, TypeParam(0.25));
  const auto pose = ph::xy_table<TypeParam>().inverse(x);
  EXPECT_EQ(pose.outcome, ph::status::ok);
  EXPECT_EQ(ph::xy_table<TypeParam>().position(pose.q), x);
}

}  // namespace
