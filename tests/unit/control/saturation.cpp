// Torque limits, by themselves and in a whole step.
#include "../support.hpp"

#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <algorithm>
#include <limits>

namespace {

using V = ph::vector<double, 2>;
constexpr double most = std::numeric_limits<double>::max();
constexpr double least = std::numeric_limits<double>::denorm_min();

ph::saturated_torque<double, 2> keep(const V& t, double scale, const V& limit) {
  return ph::saturate(V(scale * t), limit, ph::saturation::keep_direction);
}
ph::saturated_torque<double, 2> clamp(const V& t, double scale, const V& limit) {
  return ph::saturate(V(scale * t), limit, ph::saturation::clamp_each);
}

TEST(saturation, within_the_limits_nothing_changes) {
  for (const auto& result : {keep({1, -2}, 3, {4, 6}), clamp({1, -2}, 3, {4, 6})}) {
    EXPECT_EQ(result.torque, V(3, -6));
    EXPECT_FALSE(result.limited);
  }
}

TEST(saturation, beyond_them_the_direction_is_kept_or_each_brake_gives_what_it_can) {
  const auto kept = keep({1, -2}, 8, {4, 4});
  EXPECT_EQ(kept.torque, V(2, -4));
  EXPECT_TRUE(kept.limited);
  const auto clamped = clamp({1, -2}, 8, {4, 4});
  EXPECT_EQ(clamped.torque, V(4, -4));
  EXPECT_TRUE(clamped.limited);
  EXPECT_EQ(keep({-1, 2}, 8, {4, 100}).torque, V(-4, 8));
  EXPECT_EQ(clamp({-1, 2}, 8, {4, 100}).torque, V(-4, 16));
}

TEST(saturation, a_brake_that_is_off_stays_off) {
  for (const double scale : {0.0, 1.0, most}) {
    EXPECT_EQ(keep({0, 0}, scale, {1, 1}).torque, V(0, 0));
    EXPECT_EQ(clamp({0, 0}, scale, {1, 1}).torque, V(0, 0));
  }
  EXPECT_EQ(keep({0, 2}, 1, {0, 4}).torque, V(0, 2)) << "a limit of 0 on a brake that is off limits nothing";
}

TEST(saturation, a_limit_of_zero_releases_all_or_only_its_brake) {
  EXPECT_EQ(keep({1, 2}, 1, {0, 4}).torque, V(0, 0));
  EXPECT_EQ(clamp({1, 2}, 1, {0, 4}).torque, V(0, 2));
  EXPECT_TRUE(keep({1, 2}, 1, {0, 4}).limited);
  EXPECT_TRUE(clamp({1, 2}, 1, {0, 4}).limited);
}

TEST(saturation, the_largest_torques_end_at_the_limits) {
  const auto kept = keep({most / 2, -most}, 1, {1, 1});
  expect_near(kept.torque, V(0.5, -1), 1);  // the factor is a denormal number
  EXPECT_LE(-kept.torque[1], 1);
  EXPECT_TRUE(kept.limited);
  const auto clamped = clamp({most / 2, -most}, 1, {1, 1});
  EXPECT_EQ(clamped.torque, V(1, -1));
  EXPECT_TRUE(clamped.limited);
  EXPECT_EQ(clamp({most, -most}, 1, {most, most}).torque, V(most, -most));
  EXPECT_TRUE(ph::all_finite(keep({most, least}, 1, {most, 1}).torque));
}

TEST(saturation, denormal_torques_stay_finite_and_within_the_limits) {
  EXPECT_EQ(keep({least, 1}, 1, {1, 1}).torque, V(least, 1));
  const auto tiny = keep({most, least}, 1, {least, 1});
  EXPECT_LE(tiny.torque[0], least);
  EXPECT_TRUE(ph::all_finite(tiny.torque));
}

// The law holds of every brake: keep_direction scales all by the smallest factor that one of them needs.
TEST(saturation, of_a_step_scales_all_brakes_by_the_smallest_factor_or_cuts_each) {
  using M = ph::tendon_two_link<double>;
  constexpr unsigned seed = 20040627;
  ph::testing::random_source random(seed);
  int cut[3] = {};
  for (int k = 0; k < 1000; ++k) {
    const auto state = state_of<M>({random.uniform(0.3, 0.9), random.uniform(0.3, 0.9)},
                                   {random.wide(0.1, 3.0), random.wide(0.1, 3.0)});
    ph::contacts<2, 1> touched;
    touched.push_back(asking_for<2>(random.positive(0.1, 100.0) * random.direction<double, 2>()));
    const auto step = [&](const auto& brakes, ph::saturation policy) {
      ph::step_memory<ph::no_direct_control> memory;
      ph::step_options<double> options;
      options.limits = policy;
      return ph::step(M(), brakes, touched, ph::no_direct_control{}, state, memory, options);
    };
    const V free = step(ph::unlimited_brakes(), ph::saturation::clamp_each).capacity;
    ph::brakes_of<M> brakes;
    for (int i = 0; i < 2; ++i) {
      brakes.torque_limit[i] = random.positive(0.1, 3.0) * (free[i] > 0 ? free[i] : 1);
      brakes.rate_dead_band[i] = 0;
    }
    double factor = 1;
    int over = 0;
    for (int i = 0; i < 2; ++i) {
      if (free[i] > brakes.torque_limit[i]) ++over;
      if (free[i] > 0) factor = std::min(factor, brakes.torque_limit[i] / free[i]);
    }
    ++cut[over];
    const auto kept = step(brakes, ph::saturation::keep_direction),
               clamped = step(brakes, ph::saturation::clamp_each);
    expect_near(kept.capacity, V(factor * free), free.norm());
    expect_near(clamped.capacity, V(free.cwiseMin(brakes.torque_limit)), free.norm());
    for (const auto& result : {kept, clamped}) {
      ASSERT_TRUE((result.capacity.array() <= brakes.torque_limit.array()).all())
          << "seed " << seed << ", trial " << k;
      ASSERT_EQ(result.saturated, over > 0) << "seed " << seed << ", trial " << k;
    }
  }
  for (int over = 0; over <= 2; ++over) EXPECT_GT(cut[over], 50) << over << " brakes over their limits";
}

}  // namespace
