// The figures of a run, on depths made by hand.
#include <passive_haptics/plant/contact_metrics.hpp>

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
  EXPECT_DOUBLE_EQ(figures({-50, -50, 1, 1, 1, -50}).duration, 4e-3);
  const auto r = figures({-50, -50, 0, -20});
  EXPECT_EQ(r.separations, 0);
  EXPECT_EQ(r.duration, 0);
  EXPECT_EQ(r.stick_share, 0);
  for (const double figure :
       {r.retarding_force, r.depth_range, r.depth_mean, r.depth_drift, r.hand_force_std})
    EXPECT_EQ(figure, 0);
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

// Ten samples from the first contact at 0: the first tenth of the path is left out.
TEST(contact_meter, measures_depth_after_the_first_tenth_of_the_path) {
  const auto r = figures({1000, 10, 20, 30, 10, 20, 30, 10, 20, 30});
  EXPECT_DOUBLE_EQ(r.max_depth, 1000 * um);
  EXPECT_NEAR(r.depth_range, 20 * um, 1e-18);
  EXPECT_NEAR(r.depth_std, std::sqrt(2.0 / 3) * 10 * um, 1e-18) << "about the mean of 20";
  EXPECT_NEAR(r.depth_mean, 20 * um, 1e-18);
  EXPECT_NEAR(r.depth_drift, 20 * um, 1e-18);
  EXPECT_NEAR(figures({50, 30, -40}).depth_range, 70 * um, 1e-18) << "off the wall, too";
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

}  // namespace
