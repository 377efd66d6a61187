// The hand that follows a wall, against closed forms.
#include "../../tested_types.hpp"

#include <passive_haptics/plant/following_hand.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace ph = passive_haptics;

namespace {

template <class T>
struct following_hand : ::testing::Test {};
using hand_scalars = tested_types<double, float>;
TYPED_TEST_SUITE(following_hand, hand_scalars);

// speed 0.05, stiffness 200, damping 20, push 2, normal damping 20
TYPED_TEST(following_hand, pulls_along_the_wall_and_presses_on_it) {
  using T = TypeParam;
  using V = ph::vector<T, 2>;
  const ph::following_hand<T, 2> hand({3, 0}, {T(0.1), T(0.7)});
  const V n(0, -1);
  const auto expect = [&](const V& actual, T x, T y) {
    EXPECT_NEAR(actual[0], x, T(1e-5));
    EXPECT_NEAR(actual[1], y, T(1e-5));
  };
  expect(hand.force(0, {T(0.1), 0}, {T(0.05), 0}, n, 0), 0, 2);   // where and as fast as intended
  expect(hand.force(2, {T(0.1), 0}, {T(0.05), 0}, n, 0), 20, 2);  // 0.1 m late
  expect(hand.force(0, {T(0.1), 0}, {0, 0}, n, 0), 1, 2);         // too slow
  expect(hand.force(0, {T(0.1), 0}, {T(0.05), T(0.1)}, n, 0), 0,
         T(2) - T(2));  // sinking: the damping holds back
  EXPECT_NEAR(hand.progress({T(0.3), T(9)}), T(0.3), T(1e-6));
  EXPECT_EQ(hand.parameters().push, T(2));
}

TYPED_TEST(following_hand, pushes_less_where_the_wall_lets_it_in) {
  using T = TypeParam;
  ph::following_hand_parameters<T> p;
  p.normal_stiffness = 300;
  p.target_depth = T(0.003);
  const ph::following_hand<T, 2> hand({1, 0}, {0, 0}, p);
  const auto into = [&](T depth) { return hand.force(0, {0, 0}, {T(0.05), 0}, {0, -1}, depth)[1]; };
  EXPECT_NEAR(into(T(0.003)), T(2), T(1e-5));
  EXPECT_NEAR(into(0), T(2.9), T(1e-5));
  EXPECT_NEAR(into(T(0.003) + T(2) / 300), 0, T(1e-5));
}

TYPED_TEST(following_hand, follows_a_slanted_wall_no_harder_than_through_a_third) {
  using T = TypeParam;
  using V = ph::vector<T, 2>;
  ph::following_hand_parameters<T> p;
  p.damping = 0;
  p.push = 0;
  const ph::following_hand<T, 2> hand({1, 0}, {0, 0}, p);
  const auto along = [&](T degrees) {
    const T a = ph::radians(degrees);
    return hand.force(2, {0, 0}, {0, 0}, V(std::sin(a), -std::cos(a)), 0).norm();
  };
  EXPECT_NEAR(along(60), T(20) / T(0.5), T(1e-3));
  EXPECT_NEAR(along(80), T(20) / T(0.3), T(1e-3));
  EXPECT_NEAR(hand.min_time_constant(3), std::sqrt(T(3) * T(0.3) / 200), T(1e-6)) << "there it is stiffest";
}

TYPED_TEST(following_hand, keeps_its_direction_if_it_is_normal_to_the_wall) {
  using T = TypeParam;
  using V = ph::vector<T, 2>;
  const ph::following_hand<T, 2> hand({1, 0}, {0, 0});
  EXPECT_EQ(hand.tangent(V(1, 0)), V(1, 0));
  const V t = hand.tangent(V(T(0.6), T(-0.8)));
  EXPECT_NEAR(t[0], T(0.8), T(1e-6));
  EXPECT_NEAR(t[1], T(0.6), T(1e-6));
}

}  // namespace
