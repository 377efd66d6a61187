// Nearest forces and approximations by hand: axes alone, the empty cone, right angles and the largest angle.
#include <passive_haptics/force/approximation.hpp>
#include <passive_haptics/force/torques/generator_form.hpp>

#include <gtest/gtest.h>

namespace ph = passive_haptics;

namespace {

using force = ph::vector<double, 2>;
using three = ph::vector<double, 3>;

TEST(nearest_force, of_axes_alone_leaves_out_those_that_would_drive) {
  const ph::diagonal_matrix<double, 2> E(2, -0.5);
  const auto nearest = [&](double s_0, double s_1) { return ph::nearest_force(E, {s_0, s_1}, force(3, 4)); };
  EXPECT_EQ(nearest(1, 1).force, force(0, 4));
  EXPECT_EQ(nearest(1, 1).active, 1u);
  EXPECT_EQ(nearest(-1, -1).force, force(3, 0));
  EXPECT_EQ(nearest(-1, -1).active, 2u);
  EXPECT_EQ(nearest(1, -1).force, force(0, 0));
  EXPECT_EQ(nearest(1, -1).active, 3u);
  EXPECT_EQ(nearest(-1, 0).force, force(3, 4));
  EXPECT_EQ(nearest(-1, 0).active, 0u);
}

TEST(cone_is_zero, where_half_spaces_face_away_from_each_other_all_around) {
  const ph::matrix<double, 2, 3> around{{2, 0, -1}, {-1, 1, 0}}, opposed{{1, -2, 0}, {0, 0, 0}};
  EXPECT_TRUE(ph::cone_is_zero(around, three(1, 1, 1)));
  EXPECT_TRUE(ph::cone_is_zero(around, three(-1, -1, -1)));
  EXPECT_FALSE(ph::cone_is_zero(around, three(1, 1, -1)));
  EXPECT_FALSE(ph::cone_is_zero(around, three(1, 1, 0)));
  EXPECT_FALSE(ph::cone_is_zero(opposed, three(1, 1, 1))) << "a line is left";
}

// Where the nearest force is 0 there is nothing to make longer.
TEST(approximation, is_none_at_a_right_angle_even_if_any_angle_will_do) {
  const auto expect_none = [](const auto& F) {
    EXPECT_EQ(F.display, ph::display_class::none);
    EXPECT_TRUE(F.force.isZero(0) && F.torque.isZero(0));
    EXPECT_EQ(F.cosine_squared, 0);
  };
  const ph::matrix<double, 2, 2> axes{{1, 0}, {0, 1}};
  for (const double s_1 : {-1.0, 1.0}) expect_none(ph::approximate(axes, force(1, s_1), force(1, 0), 0.0));
  const ph::matrix<double, 2, 3> E{{1, 0, 1}, {0, 1, 1}}, G{{1, 2, 1}, {0, 0, 0}};
  expect_none(ph::approximate(E, three(1, 1, 1), force(0.6, 0.8), 0.0));
  expect_none(ph::approximate_by_generators(G, three(-1, -1, -1), force(-0.6, 0.8), 0.0));
}

TEST(approximation, by_generators_ends_at_the_largest_angle) {
  const ph::matrix<double, 2, 3> G{{1, 2, 1}, {0, 0, 0}};
  const force n(0.6, 0.8);
  const auto F = ph::approximate_by_generators(G, three(-1, -1, -1), n, 0.59);
  EXPECT_EQ(F.display, ph::display_class::approximate);
  EXPECT_TRUE(F.force.isApprox(force(1 / 0.6, 0), 1e-15));
  EXPECT_NEAR(F.cosine(), 0.6, 1e-15);
  EXPECT_EQ(ph::approximate_by_generators(G, three(-1, -1, -1), n, 0.61).display, ph::display_class::none);
}

}  // namespace
