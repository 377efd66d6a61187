// Closed chains by hand: elbows at one place, brakes, symmetry, parameters.
#include <passive_haptics/core/finite.hpp>
#include <passive_haptics/mechanism/jacobian.hpp>
#include <passive_haptics/mechanism/models/delta.hpp>
#include <passive_haptics/mechanism/models/five_bar.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace ph = passive_haptics;

namespace {

constexpr double pi = std::numbers::pi, eps = std::numeric_limits<double>::epsilon();

// Elbows at one place: the handle may be anywhere about it, and what rounding makes of it is no pose.
template <class M>
void expect_no_pose(const M& chain, const ph::joint_vector<M>& q) {
  SCOPED_TRACE(::testing::Message() << "q = " << q.transpose());
  EXPECT_FALSE(ph::all_finite(chain.position(q)));
  EXPECT_FALSE(ph::all_finite(chain.jacobian(q)));
}

TEST(coinciding_elbows, of_a_five_bar_leave_no_pose) {
  const ph::five_bar<double> square(
      {.base_distance = 0.2, .proximal_1 = 0.1, .proximal_2 = 0.1, .distal_1 = 0.1, .distal_2 = 0.1});
  expect_no_pose(square, {0, pi});
  const ph::five_bar<double> usual;
  const double meet = std::acos(usual.parameters().base_distance / 2 / usual.parameters().proximal_1);
  expect_no_pose(usual, {meet, pi - meet});
  const ph::five_bar<double> coaxial({.base_distance = 0});
  expect_no_pose(coaxial, {1.2, 1.2});
}

TEST(coinciding_elbows, of_a_delta_leave_no_pose) {
  const ph::delta<double> chain(
      {.base_radius = 0.1, .platform_radius = 0.05, .upper_arm = 0.2, .forearm = 0.3});
  const double q = std::acos(-0.25);  // on the axis
  expect_no_pose(chain, {q, q, 0.3});
  expect_no_pose(chain, {0.3, q, q});
  expect_no_pose(chain, {q, q, q});
}

// Where the determinant of the distal links is nothing but rounding, so would be J.
TEST(coinciding_elbows, nearly_of_a_delta_leave_no_jacobian) {
  ph::delta_parameters<double> p;
  p.base_radius = p.platform_radius;
  const double q = pi / 2, little = 1e-9;
  EXPECT_FALSE(ph::all_finite(ph::delta<double>(p).jacobian({q - little, q, q + little})));
}

// The elbows part along x, by 2 l sin(q) a radian; the handle jumps over them, and along one direction J is
// unbounded.
TEST(coinciding_elbows, nearly_of_a_five_bar_have_a_finite_inverse_jacobian) {
  const ph::five_bar<double> chain;
  const auto& p = chain.parameters();
  const double meet = std::acos(p.base_distance / 2 / p.proximal_1);
  const double slope = 2 * p.proximal_1 * std::sin(meet) / p.distal_1;
  for (const double away : {-1e-3, -1e-6, 1e-6, 1e-3}) {
    SCOPED_TRACE(away);
    const ph::vector<double, 2> q(meet + away, pi - meet - away);
    const double type_2 = chain.conditioning(q).type_2;
    EXPECT_NEAR(type_2, slope * std::abs(away), 10 * away * away + 16 * eps);
    EXPECT_LE(chain.inverse_jacobian(q).norm(), 100 / p.proximal_1);
    EXPECT_GT(chain.jacobian(q).norm() * type_2, 1e-3);
  }
}

TEST(five_bar, with_four_brakes_measures_both_rates_their_difference_and_their_sum) {
  const ph::five_bar<double, 4> chain;
  const ph::vector<double, 4> w = ph::brake_rates(chain, {2, 1}, {0.5, 0.2});
  EXPECT_TRUE(w.isApprox(ph::vector<double, 4>(0.5, 0.2, 0.3, 0.7), 1e-15));
  static_assert(ph::Dynamics<ph::five_bar<float, 4>> && ph::ClosedChain<ph::five_bar<float, 4>>);
  static_assert(!ph::detail::names_transmission<ph::five_bar<double>>, "two brakes sit on the joints");
}

TEST(delta, at_equal_angles_is_symmetric_about_its_axis) {
  const ph::delta<double> chain;
  const auto& p = chain.parameters();
  for (const double q : {-0.4, 0.0, 0.7, 1.2}) {
    const ph::vector<double, 3> all = ph::vector<double, 3>::Constant(q), x = chain.position(all);
    const double out = p.base_radius - p.platform_radius + p.upper_arm * std::cos(q);
    EXPECT_NEAR(std::hypot(x[0], x[1]), 0, 1e-16);
    EXPECT_NEAR(x[2], -p.upper_arm * std::sin(q) - std::sqrt(p.forearm * p.forearm - out * out), 1e-16);
    // Together the arms move it along the axis alone
    const ph::vector<double, 3> v = chain.jacobian(all) * ph::vector<double, 3>::Ones();
    EXPECT_NEAR(std::hypot(v[0], v[1]), 0, 1e-15);
    EXPECT_LT(v[2], 0);
  }
}

TEST(delta, reaches_its_workspace_far_from_singularities) {
  const ph::delta<double> chain;
  ph::testing::random_source random(7);
  for (int k = 0; k < 300; ++k) {
    const ph::vector<double, 3> x =
        ph::vector<double, 3>(0, 0, -0.14) +
        0.05 * std::cbrt(random.uniform(0.0, 1.0)) * random.direction<double, 3>();
    SCOPED_TRACE(::testing::Message() << "seed 7, x = " << x.transpose());
    const auto s = chain.inverse(x);
    ASSERT_EQ(s.outcome, ph::status::ok);
    ASSERT_GT(chain.conditioning(s.q).type_1, 0.29);
    ASSERT_GT(chain.conditioning(s.q).type_2, 0.29);
  }
}

TEST(closed_chain_parameters, say_which_is_wrong) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  ph::five_bar_parameters<double, 4> f;
  EXPECT_EQ(validate(f), "");
  f.base_distance = -1;
  EXPECT_EQ(validate(f), "base_distance [m] = -1: expected a finite number >= 0");
  f = {}, f.distal_2 = 0;
  EXPECT_EQ(validate(f), "distal_2 [m] = 0: expected a finite number > 0");
  f = {}, f.base_distance = 1;
  EXPECT_EQ(validate(f), "longest length [m] = 1: expected less than all others together");
  f = {}, f.proximal_2 = 1;
  EXPECT_EQ(validate(f), "longest length [m] = 1: expected less than all others together");
  f = {}, f.rotor_inertia[3] = nan;
  EXPECT_EQ(validate(f), "rotor_inertia[3] [kg m^2] = nan: expected a finite number >= 0");
  EXPECT_THROW((ph::five_bar<double, 4>(f)), std::invalid_argument);

  ph::delta_parameters<double> d;
  EXPECT_EQ(validate(d), "");
  d.forearm = -0.1;
  EXPECT_EQ(validate(d), "forearm [m] = -0.1: expected a finite number > 0");
  d = {}, d.base_radius = 1;
  EXPECT_EQ(validate(d),
            "base_radius - platform_radius [m] = 0.98: expected less than upper_arm + forearm in magnitude");
  EXPECT_THROW((ph::delta<double>(d)), std::invalid_argument);
}

}  // namespace
