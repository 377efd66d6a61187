// The cone by its generators: as by half-spaces where both exist, also of brakes that are off.
#include <passive_haptics/force/forms/generator_form.hpp>
#include <passive_haptics/mechanism/models/five_bar.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace ph = passive_haptics;

namespace {

// A cone of D brakes, each on or off.
template <int D>
struct random_cone {
  ph::matrix<double, D, D> E, G;
  ph::vector<double, D> s, off, n;

  explicit random_cone(ph::testing::random_source& random) {
    do {
      for (auto& x : E.reshaped()) x = random.normal<double>();
      G = E.transpose().inverse();
    } while (!(E.norm() * G.norm() < 100));
    for (auto& x : off) x = random.coin() ? 1 : 0;
    for (auto& x : s) x = std::floor(random.uniform(-1.0, 2.0));
    n = random.direction<double, D>();
  }

  // A brake that is off makes nothing: its column of G is 0
  ph::vector<double, D> units() const { return (1 - off.array()).matrix(); }
};

// A brake that is off is a pair of opposed half-spaces.
template <int D>
void expect_both_forms_agree() {
  constexpr unsigned seed = 20040627;
  ph::testing::random_source random(seed);
  int shown = 0, none = 0;
  ph::half_space_start kept;  // from case to case
  for (int k = 0; k < 2000; ++k) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed << ", case " << k);
    const random_cone<D> c(random);
    ph::half_space_start start;
    const auto pairs = ph::approximate(c.E, c.s, c.n, 0.02, start, c.off);
    const auto generators = ph::approximate_by_generators(c.G, c.s, c.n, 0.02, c.units());
    ASSERT_EQ(pairs.display, generators.display);
    ASSERT_EQ(ph::approximate(c.E, c.s, c.n, 0.02, kept, c.off).display, pairs.display);
    // Fp is that of the projection: the scale 1 / cos^2 would enlarge its rounding
    const ph::vector<double, D> Fp = pairs.cosine_squared * pairs.force,
                                Fg = generators.cosine_squared * generators.force;
    ASSERT_LE((Fp - Fg).norm(), 2e-14);
    for (const auto& t : {pairs.torque, generators.torque}) {
      ASSERT_LE(c.s.cwiseProduct(t).maxCoeff(), 0);
      ASSERT_EQ(c.off.dot(t.cwiseAbs()), 0) << "a brake that is off";
    }
    (ph::is_displayed(pairs.display) ? shown : none) += 1;
    if (!ph::is_displayed(pairs.display)) continue;
    ASSERT_NEAR(pairs.force.dot(c.n), 1, 1e-10);
    const double size = c.E.norm() * pairs.force.norm();
    ASSERT_LE((c.E.transpose() * pairs.force - pairs.torque).norm(), 1e-13 * size);
    ASSERT_LE((pairs.torque - generators.torque).norm(), 1e-12 * (1 + size));
  }
  EXPECT_GT(shown, 500);
  EXPECT_GT(none, 200);
}

TEST(generator_form, is_the_half_space_form) {
  expect_both_forms_agree<2>();
  expect_both_forms_agree<3>();
}

TEST(half_space_form, of_brakes_that_are_on_changes_no_bit) {
  ph::testing::random_source random(6);
  const ph::vector<double, 3> none = ph::vector<double, 3>::Zero();
  for (int k = 0; k < 200; ++k) {
    const random_cone<3> c(random);
    ph::half_space_start first, second;
    const auto F = ph::approximate(c.E, c.s, c.n, 0.02, first),
               same = ph::approximate(c.E, c.s, c.n, 0.02, second, none);
    ASSERT_EQ(F.display, same.display);
    ASSERT_EQ(F.force, same.force);
    ASSERT_EQ(F.torque, same.torque);
  }
}

TEST(generator_form, is_exact_within_their_cone) {
  const ph::matrix<double, 2, 3> G{{1, 0, 0}, {0, 2, 1}};
  const ph::vector<double, 2> n(0.6, 0.8);
  const auto F = ph::approximate_by_generators(G, ph::vector<double, 3>(-1, -1, -1), n, 0.0);
  EXPECT_EQ(F.display, ph::display_class::exact);
  EXPECT_EQ(F.force, n);
  EXPECT_TRUE(F.torque.isApprox(ph::vector<double, 3>(0.6, 0.32, 0.16), 1e-15));
  EXPECT_EQ(F.cosine_squared, 1);
}

// Two generators that are nearly opposed hold a face up by long torques; what is missed beside that face
// is no rounding of theirs.
TEST(generator_form, tells_what_is_beside_a_face_of_long_torques) {
  const ph::matrix<double, 3, 3> G{{1, -1, 0}, {1e-8, 1e-8, 0}, {0, 0, 1}};
  const auto F = ph::approximate_by_generators(G, ph::vector<double, 3>(-1, -1, -1),
                                               ph::vector<double, 3>(0, 1, -1e-9), 0.0);
  EXPECT_EQ(F.display, ph::display_class::approximate);
  EXPECT_NEAR(F.torque[0], 5e7, 1);
}

TEST(generator_form, ends_at_the_largest_angle) {
  const ph::matrix<double, 2, 3> G{{1, 2, 1}, {0, 0, 0}};
  const ph::vector<double, 2> n(0.6, 0.8);
  const auto F = ph::approximate_by_generators(G, ph::vector<double, 3>(-1, -1, -1), n, 0.59);
  EXPECT_EQ(F.display, ph::display_class::approximate);
  EXPECT_TRUE(F.force.isApprox(ph::vector<double, 2>(1 / 0.6, 0), 1e-15));
  EXPECT_NEAR(F.cosine(), 0.6, 1e-15);
  EXPECT_EQ(ph::approximate_by_generators(G, ph::vector<double, 3>(-1, -1, -1), n, 0.61).display,
            ph::display_class::none);
}

TEST(torque_box, leaves_a_brake_at_rest_free_within_its_limit) {
  const auto box = ph::torques_within<double, 3>({1, -1, 0}, {2, 3, 4});
  EXPECT_EQ(box.lower, (ph::vector<double, 3>(-2, 0, -4)));
  EXPECT_EQ(box.upper, (ph::vector<double, 3>(0, 3, 4)));
}

// At a singularity of type 2 J is unbounded; its inverse, and so the generators, are not.
TEST(force_generators, of_a_closed_chain_are_finite_where_its_jacobian_is_not) {
  const ph::five_bar<double, 4> pantograph;
  const ph::vector<double, 2> q(2.2, 0.9);
  const auto G = ph::force_generators(pantograph, q);
  const ph::matrix<double, 2, 4> expected =
      pantograph.jacobian(q).transpose().inverse() * pantograph.transmission().transpose();
  EXPECT_LE((G - expected).norm(), 1e-12 * expected.norm());
}

}  // namespace
