// Resistance both ways and one way, and what is made of it: the friction of walls.
#include <passive_haptics/force/effects/rough_walls.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ph = passive_haptics;

namespace {

constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();

TEST(resistance, has_its_limit_in_slip_and_a_slope_in_the_dead_band) {
  using vector = ph::vector<double, 2>;
  const vector nobody(0, 0);
  EXPECT_LE((ph::resistance<double, 2>(5, {0.3, -0.4}, 0.1, nobody) - vector(-3, 4)).norm(), rounding);
  EXPECT_LE((ph::resistance<double, 2>(5, {0.03, -0.04}, 0.1, nobody) - vector(-1.5, 2)).norm(), rounding);
  EXPECT_EQ((ph::resistance<double, 2>(0, {0.03, -0.04}, 0.1, {1, 1})).norm(), 0);
}

TEST(resistance, at_rest_holds_a_push_up_to_its_limit) {
  using vector = ph::vector<double, 2>;
  const vector rest(0, 0);
  EXPECT_EQ((ph::resistance<double, 2>(5, rest, 0.1, {1, 2})), vector(-1, -2));
  EXPECT_LE((ph::resistance<double, 2>(5, rest, 0.1, {30, 40}) - vector(-3, -4)).norm(), rounding);
}

TEST(resistance, of_a_velocity_or_push_whose_square_overflows_has_its_limit) {
  const ph::vector<double, 2> along(0.6, 0.8), none(0, 0);
  for (const double huge : {1e155, 1e200, 1e307}) {
    EXPECT_LE((ph::resistance<double, 2>(5, huge * along, 0.1, none) + 5 * along).norm(), rounding) << huge;
    EXPECT_LE((ph::resistance<double, 2>(5, none, 0.1, huge * along) + 5 * along).norm(), rounding) << huge;
  }
  EXPECT_TRUE(std::isnan(ph::resistance<double, 2>(5, {std::nan(""), 1}, 0.1, none)[0]));
}

TEST(one_way_resistance, lets_the_other_way_free) {
  EXPECT_EQ(ph::one_way_resistance(5.0, 0.2, 0.1, 0.0), 5);
  EXPECT_EQ(ph::one_way_resistance(5.0, 0.05, 0.1, 0.0), 2.5);
  EXPECT_EQ(ph::one_way_resistance(5.0, 0.0, 0.1, 0.0), 0);
  EXPECT_EQ(ph::one_way_resistance(5.0, -0.05, 0.1, 0.0), 0);
  EXPECT_EQ(ph::one_way_resistance(5.0, -0.2, 0.1, 100.0), 0);
  EXPECT_EQ(ph::one_way_resistance(5.0, 0.2, 0.1, -9.0), 5) << "beyond the dead band no push counts";
  EXPECT_EQ(ph::one_way_resistance(5.0, 0.0125, 0.1, 0.0), 0.625);
  EXPECT_EQ(ph::one_way_resistance(5.0, 0.0, 0.1, 3.0), 3);
  EXPECT_EQ(ph::one_way_resistance(5.0, 0.0, 0.1, 7.0), 5);
  EXPECT_EQ(ph::one_way_resistance(5.0, 0.0, 0.1, -3.0), 0);
}

TEST(wall_friction, is_mu_times_the_load_against_the_motion_along_the_wall) {
  const ph::wall_friction_parameters<double> rough{.coefficient = 0.5};
  using vector = ph::vector<double, 3>;
  const vector n(0, 0, 1), v(0.3, 0.4, -7);
  EXPECT_LE((ph::wall_friction(rough, n, 8, v) - vector(-2.4, -3.2, 0)).norm(), rounding);
  EXPECT_EQ(ph::wall_friction(rough, n, 0, v).norm(), 0);
  const ph::wall_friction_parameters<double> wet{.coefficient = 0.5, .viscosity = 10};
  EXPECT_LE((ph::wall_friction(wet, n, 8, v) - vector(-5.4, -7.2, 0)).norm(), rounding);
}

TEST(rough_walls, have_the_friction_of_each_touched_wall_under_the_load_that_the_hand_presses) {
  EXPECT_EQ((ph::pressing_force(ph::vector<double, 2>(0, 1), {3, -2})), 2);
  EXPECT_EQ((ph::pressing_force(ph::vector<double, 2>(0, 1), {3, 2})), 0);
  const ph::wall_friction_parameters<double> p{.coefficient = 0.5, .viscosity = 10};
  const ph::rough_walls<double, 2> rough(p);
  const ph::vector<double, 2> v(0.3, -0.2), Fh(-4, -7), first(0, 1), second(1, 0), moving(0.1, 0.4);
  ph::contacts<2, 3> touched;
  EXPECT_EQ(rough.force_at(touched, v, Fh), (ph::vector<double, 2>(0, 0)));
  touched.push_back({.normal = first, .depth = 1e-3, .stiffness = 1e3});
  EXPECT_EQ(rough.force_at(touched, v, Fh), ph::wall_friction(p, first, 7, v, Fh));
  touched.push_back({.normal = second, .depth = 1e-3, .stiffness = 1e3, .wall_velocity = moving});
  const ph::vector<double, 2> both = ph::wall_friction(p, first, 7, v, Fh) +
                                     ph::wall_friction(p, second, 4, ph::vector<double, 2>(v - moving), Fh);
  EXPECT_LE((rough.force_at(touched, v, Fh) - both).norm(), rounding);
}

}  // namespace
