// Cones of brakes of which some are off: half-spaces in pairs and generators that make nothing agree.
#include <passive_haptics/core/linear/cone.hpp>
#include <passive_haptics/force/approximation.hpp>
#include <passive_haptics/force/forms/generator_form.hpp>

#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace ph = passive_haptics;

namespace {

// A cone of D brakes; at least one of them is off.
template <int D>
struct cone_with_brakes_off {
  ph::matrix<double, D, D> E, G;
  ph::vector<double, D> s, off, n;

  explicit cone_with_brakes_off(ph::testing::random_source& random) {
    do {
      for (auto& x : E.reshaped()) x = random.normal<double>();
      G = E.transpose().inverse();
    } while (!(E.norm() * G.norm() < 100));
    do {
      for (int i = 0; i < D; ++i) off[i] = random.coin() ? 1 : 0;
    } while (off.isZero(0));
    for (auto& x : s) x = std::floor(random.uniform(-1.0, 2.0));
    n = random.direction<double, D>();
  }

  // Brakes that are off make nothing: their columns of G are 0.
  ph::vector<double, D> units() const { return (1 - off.array()).matrix(); }
};

template <int D>
void expect_pairs_and_generators_agree() {
  constexpr unsigned seed = 20040627;
  ph::testing::random_source random(seed);
  double worst = 0;
  int shown = 0, none = 0;
  ph::half_space_start kept;  // from case to case
  for (int k = 0; k < 10'000; ++k) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed << ", case " << k);
    const cone_with_brakes_off<D> c(random);
    ph::half_space_start start;
    const auto pairs = ph::approximate(c.E, c.s, c.n, 0.02, start, c.off);
    const auto generators = ph::approximate_by_generators(c.G, c.s, c.n, 0.02, c.units());
    ASSERT_EQ(pairs.display, generators.display);
    ASSERT_EQ(ph::approximate(c.E, c.s, c.n, 0.02, kept, c.off).display, pairs.display);
    shown += ph::is_displayed(pairs.display) ? 1 : 0;
    none += ph::is_displayed(pairs.display) ? 0 : 1;
    // Fp is that of the projection: the scale 1 / cos^2 would enlarge its rounding
    const ph::vector<double, D> Fp = pairs.cosine_squared * pairs.force,
                                Fg = generators.cosine_squared * generators.force;
    worst = std::max(worst, (Fp - Fg).norm());
    for (const auto& t : {pairs.torque, generators.torque}) {
      for (int i = 0; i < D; ++i) {
        ASSERT_LE(c.s[i] * t[i], 0.0);
        if (c.off[i] != 0) {
          ASSERT_EQ(t[i], 0.0) << "brake " << i << " is off";
        }
      }
    }
    if (!ph::is_displayed(pairs.display)) continue;
    ASSERT_NEAR(pairs.force.dot(c.n), 1.0, 1e-10);
    const double size = c.E.norm() * pairs.force.norm();
    ASSERT_LE((c.E.transpose() * pairs.force - pairs.torque).norm(), 1e-13 * size)
        << "the force is that of t";
  }
  EXPECT_LT(worst, 2e-14);
  EXPECT_GT(shown, 1000);
  EXPECT_GT(none, 1000);
}

TEST(brakes_off, pairs_of_half_spaces_are_generators_that_make_nothing_in_the_plane) {
  expect_pairs_and_generators_agree<2>();
}

TEST(brakes_off, pairs_of_half_spaces_are_generators_that_make_nothing_in_space) {
  expect_pairs_and_generators_agree<3>();
}

// The closed form of the plane and the active set of four half-spaces.
TEST(brakes_off, closed_form_of_two_brakes_is_the_projection_on_pairs) {
  ph::testing::random_source random(5);
  double worst = 0;
  for (int k = 0; k < 10'000; ++k) {
    const cone_with_brakes_off<2> c(random);
    const ph::vector<double, 2> Fp =
        ph::project_onto_half_spaces(ph::half_spaces_of(c.E, c.s, c.off), c.n).point;
    ph::half_space_start start;
    const auto F = ph::approximate(c.E, c.s, c.n, 0.0, start, c.off);
    if (Fp.norm() < 1e-9) continue;
    worst = std::max(worst, (F.cosine_squared * F.force - Fp).norm());
  }
  EXPECT_LT(worst, 2e-14);
}

TEST(brakes_off, none_of_them_changes_no_bit) {
  ph::testing::random_source random(6);
  const ph::vector<double, 3> none = ph::vector<double, 3>::Zero();
  for (int k = 0; k < 1000; ++k) {
    const cone_with_brakes_off<3> c(random);
    ph::half_space_start first, second;
    const auto F = ph::approximate(c.E, c.s, c.n, 0.02, first),
               same = ph::approximate(c.E, c.s, c.n, 0.02, second, none);
    ASSERT_EQ(F.display, same.display);
    ASSERT_EQ(F.force, same.force);
    ASSERT_EQ(F.torque, same.torque);
  }
}

TEST(brakes_off, of_axes_alone_leave_the_other_axes) {
  const ph::diagonal_matrix<double, 3> E(2, 1, -0.5);
  const ph::vector<double, 3> s(-1, 0, 1), n = ph::vector<double, 3>(3, 4, 12) / 13;
  ph::half_space_start start;
  const auto F = ph::approximate(E, s, n, 0.0, start, ph::vector<double, 3>(0, 1, 0));
  EXPECT_EQ(F.display, ph::display_class::approximate);
  EXPECT_EQ(F.force[1], 0);
  EXPECT_EQ(F.torque[1], 0);
  EXPECT_NEAR(F.force.dot(n), 1, 1e-15);
  EXPECT_NEAR(F.cosine_squared, 153.0 / 169, 1e-15);
  const auto all = ph::approximate(E, s, n, 0.0, start, ph::vector<double, 3>(1, 1, 1));
  EXPECT_EQ(all.display, ph::display_class::none);
  EXPECT_TRUE(all.force.isZero(0) && all.torque.isZero(0));
}

// At a singular pose of the arm the structure holds what no brake has to.
TEST(brakes_off, at_a_singular_pose_the_structure_still_holds) {
  const ph::matrix<double, 2, 2> E{{0, 0}, {0.3, 0.15}};  // stretched along x
  using V = ph::vector<double, 2>;
  ph::half_space_start start;
  const auto along = ph::approximate(E, V(1, 1), V(1, 0), 0.02, start, V(0, 1));
  EXPECT_EQ(along.display, ph::display_class::exact);
  EXPECT_TRUE(along.torque.isZero(0));
  const auto oblique = ph::approximate(E, V(1, 1), V(0.6, 0.8), 0.02, start, V(0, 1));
  EXPECT_EQ(oblique.display, ph::display_class::approximate);
  EXPECT_TRUE(oblique.torque.isZero(0));
  EXPECT_NEAR(oblique.force[1], 0, 1e-15);
}

}  // namespace
