// The figures of a run, on depths made by hand.
#include "../../tested_types.hpp"

#include <passive_haptics/plant/contact_metrics.hpp>
#include <passive_haptics/plant/following_hand.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>

namespace ph = passive_haptics;

namespace {

constexpr double um = 1e-6;

// Depths in micrometres, one each millisecond; the path is made evenly from 0 to 1 m.
ph::contact_metrics figures(std::initializer_list<double> depths, double rate = 1) {
  ph::contact_meter meter(1, 1e-3);
  int k = 0;
  for (const double depth : depths)
    meter.add({k++ / static_cast<double>(depths.size()), depth * um, rate, 2});
  return meter.result();
}

TEST(contact_meter, counts_nothing_before_the_first_contact) {
  const auto r = figures({-50, -50, 0, -20});
  EXPECT_EQ(r.separations, 0);
  EXPECT_EQ(r.duration, 0);
  EXPECT_EQ(r.stick_share, 0);
  EXPECT_EQ(r.retarding_force, 0);
  EXPECT_EQ(r.depth_range, 0);
}

TEST(contact_meter, counts_separations_and_recontacts_beyond_ten_micrometres) {
  const auto r = figures({5, 20, -9, 5, -11, -50, 9, -11, 11, -12, 3, 12});
  EXPECT_EQ(r.separations, 2);
  EXPECT_EQ(r.recontacts, 2);
  EXPECT_EQ(figures({5, -10, 5, 10, -10}).separations, 0) << "ten are not more than ten";
  EXPECT_EQ(figures({5, -10.001}).separations, 1);
  EXPECT_EQ(figures({5, -11, 10}).recontacts, 0);
  EXPECT_EQ(figures({5, -11, 10.001}).recontacts, 1);
}

TEST(contact_meter, lasts_from_the_first_contact) {
  EXPECT_DOUBLE_EQ(figures({-50, -50, 1, 1, 1, -50}).duration, 4e-3);
}

// Ten samples from the first contact at 0: the first tenth of the path is left out.
TEST(contact_meter, measures_depth_after_the_first_tenth_of_the_path) {
  const auto r = figures({1000, 10, 20, 30, 10, 20, 30, 10, 20, 30});
  EXPECT_DOUBLE_EQ(r.max_depth, 1000 * um);
  EXPECT_NEAR(r.depth_range, 20 * um, 1e-18);
  EXPECT_NEAR(r.depth_std, std::sqrt(2.0 / 3) * 10 * um, 1e-18) << "about the mean of 20";
}

// Contact at half of the path: settled after a tenth of the other half.
TEST(contact_meter, the_path_begins_at_the_first_contact) {
  ph::contact_meter meter(1, 1e-3);
  meter.add({0.3, -50 * um, 1, 0});
  meter.add({0.5, 1000 * um, 1, 0});
  meter.add({0.54, 900 * um, 1, 0});
  meter.add({0.56, 40 * um, 1, 0});
  meter.add({0.8, 10 * um, 1, 0});
  EXPECT_NEAR(meter.result().depth_range, 30 * um, 1e-18);
}

TEST(contact_meter, mean_and_drift_are_those_after_the_first_tenth) {
  const auto r = figures({1000, 10, 20, 30, 10, 20, 30, 10, 20, 36});
  EXPECT_NEAR(r.depth_mean, 186.0 / 9 * um, 1e-18);
  EXPECT_NEAR(r.depth_drift, 26 * um, 1e-18);
  EXPECT_EQ(figures({-50, -50}).depth_mean, 0);
  EXPECT_EQ(figures({-50, -50}).depth_drift, 0);
}

TEST(contact_meter, sums_energy_and_keeps_the_largest_power_from_the_first_contact) {
  ph::contact_meter meter(1, 1e-3);
  meter.add({.depth = -um, .brake_energy = 8, .brake_power = 9});
  meter.add({.depth = um, .brake_energy = 0.5, .brake_power = -3});
  EXPECT_EQ(meter.result().max_brake_power, 0) << "a brake that takes power gives none";
  meter.add({.depth = um, .brake_energy = 0.25, .brake_power = 2});
  meter.add({.depth = um, .brake_energy = 0.25, .brake_power = 1});
  EXPECT_EQ(meter.result().brake_energy, 1);
  EXPECT_EQ(meter.result().max_brake_power, 2);
}

TEST(contact_meter, range_includes_what_lies_off_the_wall) {
  EXPECT_NEAR(figures({50, 30, -40}).depth_range, 70 * um, 1e-18);
}

TEST(contact_meter, shares_sticking_and_force_over_the_time_in_the_experiment) {
  ph::contact_meter meter(1, 1e-3);
  for (const double rate : {0.0, 0.0009, -0.0009, 0.001, -5.0})
    meter.add({0.5, um, rate, rate < 0 ? 4.0 : 1.0});
  EXPECT_DOUBLE_EQ(meter.result().stick_share, 0.6);
  EXPECT_DOUBLE_EQ(meter.result().retarding_force, 11.0 / 5);
}

TEST(contact_meter, knows_whether_the_end_was_reached) {
  ph::contact_meter meter(1, 1e-3);
  meter.add({0.999, um, 0, 0});
  EXPECT_FALSE(meter.result().arrived);
  meter.add({1.0, um, 0, 0});
  EXPECT_TRUE(meter.result().arrived);
}

TEST(contact_metrics, spread_of_the_hands_force_is_counted_from_the_first_contact) {
  ph::contact_meter meter(1, 1e-3);
  meter.add({.depth = -um, .hand_force = 100});
  for (const double force : {1.0, 3.0, 1.0, 3.0}) meter.add({.depth = um, .hand_force = force});
  EXPECT_NEAR(meter.result().hand_force_std, 1, 1e-12);
  EXPECT_EQ(ph::contact_meter(1, 1e-3).result().hand_force_std, 0);
}

// After the first tenth of the path, a mean depth in mm.
ph::contact_metrics at_depth(double mm) {
  ph::contact_meter meter(1, 1e-3);
  meter.add({0, um, 1, 0});
  for (int k = 0; k < 10; ++k) meter.add({0.5, mm * 1e-3, 1, 0});
  return meter.result();
}

TEST(contact_metrics, say_what_went_wrong) {
  EXPECT_TRUE(figures({-50, -50}).never_touches());
  EXPECT_FALSE(figures({-50, 1}).never_touches());
  EXPECT_FALSE(figures({5, 20}).separates());
  EXPECT_TRUE(figures({5, -20}).separates());
  EXPECT_FALSE(at_depth(-0.49).floats());
  EXPECT_TRUE(at_depth(-0.51).floats());
  EXPECT_FALSE(at_depth(9.99).is_deep());
  EXPECT_TRUE(at_depth(10.01).is_deep());
}

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
}

TYPED_TEST(following_hand, keeps_its_direction_where_it_is_normal_to_the_wall) {
  using T = TypeParam;
  using V = ph::vector<T, 2>;
  const ph::following_hand<T, 2> hand({1, 0}, {0, 0});
  EXPECT_EQ(hand.tangent(V(1, 0)), V(1, 0));
  const V t = hand.tangent(V(T(0.6), T(-0.8)));
  EXPECT_NEAR(t[0], T(0.8), T(1e-6));
  EXPECT_NEAR(t[1], T(0.6), T(1e-6));
}

}  // namespace
