// The cone by its generators: the same as by half-spaces where both exist; inertial forces; the empty cone.
#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/control/ways/generator_form.hpp>
#include <passive_haptics/control/ways/settled_form.hpp>
#include <passive_haptics/mechanism/adaptors/with_self_motion.hpp>
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

// F = G t accelerates the end effector as the brakes do: J M^-1 J^T F = J M^-1 T^T t.
TEST(inertial_forces, accelerate_the_end_effector_as_the_brakes_do) {
  using chain = ph::serial_chain_with_inertia<double, 3, 2>;
  auto parameters = ph::planar_arm<double>(std::array<double, 3>{0.2, 0.15, 0.1});
  ph::serial_chain_inertia<double, 3, 2> inertia;
  for (auto& link : inertia.links) {
    link.mass = 0.2;
    link.about_centre.setConstant(1e-3);
  }
  const chain arm(parameters, inertia);
  std::mt19937_64 engine(3);
  std::uniform_real_distribution<double> angle(-2, 2);
  for (int k = 0; k < 200; ++k) {
    const ph::vector<double, 3> q(angle(engine), angle(engine), angle(engine)),
        t(angle(engine), angle(engine), angle(engine));
    const auto J = arm.jacobian(q);
    const auto G = ph::inertial_force_generators(arm, q);
    const ph::matrix<double, 3, 3> W = arm.mass_matrix(q).inverse();
    const ph::vector<double, 2> by_force = J * W * J.transpose() * G * t, by_brakes = J * W * t;
    ASSERT_LE((by_force - by_brakes).norm(), 1e-11 * (1 + by_brakes.norm())) << "case " << k << ", seed 3";
  }
}

// What a planar 3R arm can display: leaving its self-motion alone often nothing, inertially always something.
TEST(self_motion, leaves_an_empty_cone_in_about_a_quarter_of_the_poses_of_a_planar_3R_arm) {
  using chain = ph::serial_chain<double, 3, 2>;
  const chain arm(ph::planar_arm<double>(std::array<double, 3>{0.2, 0.2, 0.2}));
  std::mt19937_64 engine(4);
  std::uniform_real_distribution<double> angle(-3.1, 3.1);
  const int poses = 20000;
  int empty = 0;
  for (int k = 0; k < poses; ++k) {
    const auto E = ph::brake_jacobian(arm, {angle(engine), angle(engine), angle(engine)});
    const ph::vector<double, 3> s(angle(engine) > 0 ? 1 : -1, angle(engine) > 0 ? 1 : -1,
                                  angle(engine) > 0 ? 1 : -1);
    const bool zero = ph::cone_is_zero(E, s);
    empty += zero;
    // By looking into 64 directions: if one of them is displayable, the cone is not {0}.
    bool found = false;
    for (int a = 0; a < 64 && !found; ++a) {
      const ph::vector<double, 2> n(std::cos(0.0982 * a), std::sin(0.0982 * a));
      found = ph::nearest_force(E, s, n).force.norm() > 1e-9;
    }
    ASSERT_EQ(found, !zero) << "case " << k << ", seed 4";
  }
  const double share = static_cast<double>(empty) / poses;
  std::printf("empty cone in %.1f %% of %d poses\n", 100 * share, poses);
  EXPECT_NEAR(share, 0.25, 0.02);
}

TEST(self_motion, is_reported_by_a_step) {
  using chain = ph::kinetostatic_mechanism<ph::serial_chain<double, 3, 2>>;
  const chain arm(
      ph::serial_chain<double, 3, 2>(ph::planar_arm<double>(std::array<double, 3>{0.2, 0.2, 0.2})));
  const ph::vector<double, 3> q(0.3, 1.2, -0.8);
  const ph::point<2> x = arm.position(q);
  int seen[5] = {};
  for (int a = 0; a < 8; ++a) {
    const ph::point<2> n(std::cos(0.8 * a + 0.1), std::sin(0.8 * a + 0.1));
    ph::controller control(arm, ph::brakes_of<chain>(),
                           ph::scene(ph::wall(ph::half_space<2>(x + 1e-4 * n, n))), ph::no_direct_control());
    for (int pattern = 0; pattern < 8; ++pattern) {
      const ph::device_state<chain> state{
          0, q, {pattern & 1 ? 1.0 : -1.0, pattern & 2 ? 1.0 : -1.0, pattern & 4 ? 1.0 : -1.0}, {0, 0}};
      const auto result = control(state);
      ++seen[static_cast<int>(result.display)];
      if (result.display == ph::display_class::empty_cone) {
        EXPECT_TRUE(result.capacity.isZero(0));
      }
    }
  }
  EXPECT_GT(seen[static_cast<int>(ph::display_class::approximate)], 0);
  EXPECT_GT(seen[static_cast<int>(ph::display_class::empty_cone)], 0);
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
