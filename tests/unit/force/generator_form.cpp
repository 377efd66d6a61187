// slow
// The cone by its generators: the same as by half-spaces where both exist.
#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/mechanism/chains/serial_chain_with_inertia.hpp>
#include <passive_haptics/mechanism/models/five_bar.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>

#include <gtest/gtest.h>
#include <Eigen/LU>

#include <random>

namespace ph = passive_haptics;

namespace {

template <int D>
void expect_both_forms_agree(unsigned seed) {
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> gauss;
  const double min_cosine = ph::step_options<double>().min_cosine;
  int approximate = 0;
  for (int k = 0; k < 5000; ++k) {
    SCOPED_TRACE(::testing::Message() << "case " << k << ", seed " << seed);
    ph::matrix<double, D, D> E;
    ph::vector<double, D> s, n;
    for (auto& x : E.reshaped()) x = gauss(engine);
    for (auto& x : s) x = static_cast<double>(static_cast<int>(engine() % 3)) - 1;
    for (auto& x : n) x = gauss(engine);
    n.normalize();
    const Eigen::FullPivLU<ph::matrix<double, D, D>> lu(E.transpose());
    if (lu.rcond() < 1e-3) continue;
    const ph::matrix<double, D, D> G = lu.inverse();
    const auto by_half_spaces = ph::approximate(E, s, n, min_cosine);
    const auto by_generators = ph::approximate_by_generators(G, s, n, min_cosine);
    ASSERT_EQ(by_half_spaces.display, by_generators.display);
    const double size = 1e-12 * (1 + by_half_spaces.force.norm());
    ASSERT_LE((by_half_spaces.force - by_generators.force).norm(), size);
    ASSERT_LE((by_half_spaces.torque - by_generators.torque).norm(), size * E.norm());
    approximate += by_half_spaces.display == ph::display_class::approximate;
  }
  EXPECT_GT(approximate, 500);
}

}  // namespace

TEST(generator_form, is_the_half_space_form_in_the_plane) { expect_both_forms_agree<2>(1); }
TEST(generator_form, is_the_half_space_form_in_space) { expect_both_forms_agree<3>(2); }

// Beyond space; the third and the fourth generator differ by little and their torques are long.
TEST(generator_form, in_four_dimensions_is_exact_where_torques_are_long) {
  using four = ph::vector<double, 4>;
  const ph::matrix<double, 4, 4> axes = four(1, 2, 4, 8).asDiagonal();
  const auto each = ph::nearest_torque(axes, four(-1, -1, 1, 1), four(3, -4, 4, -4));
  EXPECT_EQ(each.torque, four(3, 0, 0, -0.5));
  EXPECT_EQ(each.force, four(3, 0, 0, -4));

  ph::matrix<double, 4, 4> G = axes;
  G.col(2) << 7e7, 0.1, 0.3, 1;
  G.col(3) << -3e7, 0.2, 0.7, -1;
  const four n = (G * four(0.1, 0.1, 0.3, 0.7)).normalized();
  const auto F = ph::approximate_by_generators(G, four(-1, -1, -1, -1), n, 0.0);
  EXPECT_EQ(F.display, ph::display_class::exact) << F.force.transpose() << "\n" << n.transpose();
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
