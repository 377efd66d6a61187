// slow
// Nearest forces and approximations of three brakes by hand: right angles and the largest
// angle.
#include <passive_haptics/force/approximation.hpp>
#include <passive_haptics/force/forms/generator_form.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

namespace ph = passive_haptics;

namespace {

using pair = ph::vector<double, 2>;
using triple = ph::vector<double, 3>;

// Where the nearest force is 0 there is nothing to make longer.
TEST(approximation, is_none_at_a_right_angle_even_if_any_angle_will_do) {
  const auto expect_none = [](const auto& F) {
    EXPECT_EQ(F.display, ph::display_class::none);
    EXPECT_TRUE(F.force.isZero(0) && F.torque.isZero(0));
    EXPECT_EQ(F.cosine_squared, 0);
  };
  const ph::matrix<double, 2, 2> axes{{1, 0}, {0, 1}};
  for (const double s_1 : {-1.0, 1.0}) expect_none(ph::approximate(axes, pair(1, s_1), pair(1, 0), 0.0));
  const ph::matrix<double, 2, 3> E{{1, 0, 1}, {0, 1, 1}}, G{{1, 2, 1}, {0, 0, 0}};
  expect_none(ph::approximate(E, triple(1, 1, 1), pair(0.6, 0.8), 0.0));
  expect_none(ph::approximate_by_generators(G, triple(-1, -1, -1), pair(-0.6, 0.8), 0.0));
}

TEST(approximation, by_generators_is_exact_within_their_cone) {
  const ph::matrix<double, 2, 3> G{{1, 0, 0}, {0, 2, 1}};
  const pair n(0.6, 0.8);
  const auto F = ph::approximate_by_generators(G, triple(-1, -1, -1), n, 0.0);
  EXPECT_EQ(F.display, ph::display_class::exact);
  EXPECT_EQ(F.force, n);
  EXPECT_TRUE(F.torque.isApprox(triple(0.6, 0.32, 0.16), 1e-15));
  EXPECT_EQ(F.cosine_squared, 1);
}

// Two generators that are nearly opposed hold a face up by long torques; what is missed beside that face
// is no rounding of theirs.
TEST(approximation, by_generators_tells_what_is_beside_a_face_of_long_torques) {
  const ph::matrix<double, 3, 3> G{{1, -1, 0}, {1e-8, 1e-8, 0}, {0, 0, 1}};
  const auto F = ph::approximate_by_generators(G, triple(-1, -1, -1), triple(0, 1, -1e-9), 0.0);
  EXPECT_EQ(F.display, ph::display_class::approximate);
  EXPECT_NEAR(F.torque[0], 5e7, 1);
}

TEST(approximation, by_generators_ends_at_the_largest_angle) {
  const ph::matrix<double, 2, 3> G{{1, 2, 1}, {0, 0, 0}};
  const pair n(0.6, 0.8);
  const auto F = ph::approximate_by_generators(G, triple(-1, -1, -1), n, 0.59);
  EXPECT_EQ(F.display, ph::display_class::approximate);
  EXPECT_TRUE(F.force.isApprox(pair(1 / 0.6, 0), 1e-15));
  EXPECT_NEAR(F.cosine(), 0.6, 1e-15);
  EXPECT_EQ(ph::approximate_by_generators(G, triple(-1, -1, -1), n, 0.61).display, ph::display_class::none);
}

TEST(approximation, in_space_gives_no_torque_at_all_to_a_released_brake) {
  ph::testing::random_source random(2);
  int released = 0;
  for (int k = 0; k < 100; ++k) {
    ph::matrix<double, 3, 3> E;
    for (int i = 0; i < 3; ++i) E.col(i) = random.direction<double, 3>();
    const triple s(k % 2 * 2 - 1, 1, -1), n = random.direction<double, 3>();
    const auto F = ph::approximate(E, s, n, 0.02);
    if (F.display != ph::display_class::approximate) continue;
    const auto active = ph::nearest_force(E, s, n).active;
    for (int i = 0; i < 3; ++i) {
      const bool is_released = (active >> i & 1u) != 0;
      EXPECT_TRUE(is_released ? F.torque[i] == 0 : s[i] * F.torque[i] < 0) << "seed 2, trial " << k;
      released += is_released;
    }
  }
  EXPECT_GT(released, 20);
}

}  // namespace
