// Torque limits.
#include "../support.hpp"

#include <limits>

namespace {

template <class T>
struct saturation : ::testing::Test {
  using torques = ph::vector<T, 2>;
  static constexpr T most = std::numeric_limits<T>::max();
  static constexpr T least = std::numeric_limits<T>::denorm_min();
  static auto keep(const torques& t, T scale, const torques& limit) {
    return ph::saturate(torques(scale * t), limit, ph::saturation::keep_direction);
  }
  static auto clamp(const torques& t, T scale, const torques& limit) {
    return ph::saturate(torques(scale * t), limit, ph::saturation::clamp_each);
  }
};
TYPED_TEST_SUITE(saturation, scalars);

TYPED_TEST(saturation, within_the_limits_nothing_changes) {
  using V = ph::vector<TypeParam, 2>;
  for (const auto& result : {this->keep({1, -2}, 3, {4, 6}), this->clamp({1, -2}, 3, {4, 6})}) {
    EXPECT_EQ(result.torque, V(3, -6));
    EXPECT_FALSE(result.limited);
  }
}

TYPED_TEST(saturation, beyond_them_the_direction_is_kept_or_each_brake_gives_what_it_can) {
  using V = ph::vector<TypeParam, 2>;
  const auto kept = this->keep({1, -2}, 8, {4, 4});
  EXPECT_EQ(kept.torque, V(2, -4));
  EXPECT_TRUE(kept.limited);
  const auto clamped = this->clamp({1, -2}, 8, {4, 4});
  EXPECT_EQ(clamped.torque, V(4, -4));
  EXPECT_TRUE(clamped.limited);
  EXPECT_EQ(this->keep({-1, 2}, 8, {4, 100}).torque, V(-4, 8));
  EXPECT_EQ(this->clamp({-1, 2}, 8, {4, 100}).torque, V(-4, 16));
}

TYPED_TEST(saturation, a_brake_that_is_off_stays_off) {
  using V = ph::vector<TypeParam, 2>;
  for (const TypeParam scale : {TypeParam(0), TypeParam(1), this->most}) {
    EXPECT_EQ(this->keep({0, 0}, scale, {1, 1}).torque, V(0, 0));
    EXPECT_EQ(this->clamp({0, 0}, scale, {1, 1}).torque, V(0, 0));
  }
  EXPECT_EQ(this->keep({0, 2}, 1, {0, 4}).torque, V(0, 2))
      << "a limit of 0 on a brake that is off limits nothing";
}

TYPED_TEST(saturation, a_limit_of_zero_releases_all_or_only_its_brake) {
  using V = ph::vector<TypeParam, 2>;
  EXPECT_EQ(this->keep({1, 2}, 1, {0, 4}).torque, V(0, 0));
  EXPECT_EQ(this->clamp({1, 2}, 1, {0, 4}).torque, V(0, 2));
  EXPECT_TRUE(this->keep({1, 2}, 1, {0, 4}).limited);
  EXPECT_TRUE(this->clamp({1, 2}, 1, {0, 4}).limited);
}

TYPED_TEST(saturation, the_largest_torques_end_at_the_limits) {
  using T = TypeParam;
  using V = ph::vector<T, 2>;
  const auto kept = this->keep({this->most / T(2), -this->most}, 1, {1, 1});
  expect_near(kept.torque, V(T(0.5), T(-1)), 1);  // the factor is a denormal number
  EXPECT_LE(-kept.torque[1], T(1));
  EXPECT_TRUE(kept.limited);
  const auto clamped = this->clamp({this->most / T(2), -this->most}, 1, {1, 1});
  EXPECT_EQ(clamped.torque, V(1, -1));
  EXPECT_TRUE(clamped.limited);
  EXPECT_EQ(this->clamp({this->most, -this->most}, 1, {this->most, this->most}).torque,
            V(this->most, -this->most));
  EXPECT_TRUE(ph::all_finite(this->keep({this->most, this->least}, 1, {this->most, 1}).torque));
}

TYPED_TEST(saturation, denormal_torques_stay_finite_and_within_the_limits) {
  using T = TypeParam;
  using V = ph::vector<T, 2>;
  EXPECT_EQ(this->keep({this->least, 1}, 1, {1, 1}).torque, V(this->least, 1));
  const auto tiny = this->keep({this->most, this->least}, 1, {this->least, 1});
  EXPECT_LE(tiny.torque[0], this->least);
  EXPECT_TRUE(ph::all_finite(tiny.torque));
}

// The limits may stand before or after alpha: a brake that is cut first lets go as alpha falls; a command of
// 5e4 N that is scaled first stays within them.
TYPED_TEST(saturation, stands_before_or_after_alpha) {
  using T = TypeParam;
  using V = ph::vector<T, 2>;
  const V t(T(1000), T(-2000)), limit(T(1), T(1));
  const T alpha = T(1) / T(4096);
  const V after = this->keep(t, alpha, limit).torque;
  const V before = alpha * this->keep(t, 1, limit).torque;
  EXPECT_EQ(after, alpha * t) << "0.49 N m are within the limits";
  EXPECT_EQ(before, alpha * V(T(0.5), T(-1)));
}

}  // namespace
