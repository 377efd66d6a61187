// Nearest forces and approximations by hand: of two brakes as in Fig. 3, of axes, in space.
#include <passive_haptics/force/approximation.hpp>

#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>
#include <Eigen/LU>

#include <cmath>
#include <limits>

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

// Fig. 3 in scalars, as the header prints it. off: 1 for a brake that makes no torque.
ph::approximated_force<double, 2, 2> by_figure_3(const ph::matrix<double, 2, 2>& E, const force& s,
                                                 const force& n, double min_cosine, const force& off) {
  const force t = E.transpose() * n;
  const auto cannot = [&](int i) { return s[i] * t[i] > 0 || (off[i] > 0 && t[i] != 0); };
  if (!cannot(0) && !cannot(1)) return {ph::display_class::exact, n, t, 1};
  for (const int i : {0, 1}) {
    const int j = 1 - i;
    if (!cannot(j) || off[i] > 0) continue;
    const force R(-E(1, j), E(0, j));
    const double along = R.dot(n), t_i = E.col(i).dot(R) / along;
    if (s[i] * t_i <= 0 && std::abs(along) >= min_cosine * R.norm())
      return {ph::display_class::approximate, R / along, t_i * force::Unit(i),
              along * along / R.squaredNorm()};
  }
  return {};
}

// Approximations of all signs, with brakes on and off, are those of Fig. 3; the largest angle is acos(0.3).
void expect_figure_3(const ph::matrix<double, 2, 2>& E, const force& n) {
  SCOPED_TRACE(::testing::Message() << "E =\n" << E << "\nn = " << n.transpose());
  for (int k = 0; k < 36; ++k) {
    SCOPED_TRACE(k);
    const force s(k % 3 - 1, k / 3 % 3 - 1), off(k / 9 % 2, k / 18);
    ph::half_space_start start;
    const auto wanted = by_figure_3(E, s, n, 0.3, off);
    const auto expect_wanted = [&](const ph::approximated_force<double, 2, 2>& F) {
      ASSERT_EQ(F.display, wanted.display);
      EXPECT_LE((F.force - wanted.force).norm(), 1e-15 * wanted.force.norm());
      EXPECT_LE((F.torque - wanted.torque).norm(), 1e-14 * E.norm() * wanted.force.norm());
      EXPECT_NEAR(F.cosine_squared, wanted.cosine_squared, 1e-15);
    };
    expect_wanted(ph::approximate(E, s, n, 0.3, start, off));
    if (off.isZero(0)) expect_wanted(ph::approximate(E, s, n, 0.3));
    // In singular poses a diagonal E also displays what needs no torque of brakes that are off
    if (E(0, 1) == 0 && E(1, 0) == 0 && (off.isZero(0) || E.determinant() != 0))
      expect_wanted(ph::approximate(ph::diagonal_matrix<double, 2>(E(0, 0), E(1, 1)), s, n, 0.3, start, off));
  }
}

// Any, and small whole numbers: columns that are 0, parallel, opposed and at right angles to the force.
TEST(approximation, of_two_brakes_is_that_of_figure_3) {
  ph::testing::random_source random(3);
  for (int k = 0; k < 200; ++k) {
    ph::matrix<double, 2, 2> E;
    for (double& x : E.reshaped()) x = random.normal<double>();
    expect_figure_3(E, random.direction<double, 2>());
  }
  for (int k = 0; k < 5 * 5 * 5 * 5; ++k) {
    const double unit = k % 3 == 0 ? 1 : (k % 3 == 1 ? 1e-50 : 1e50);
    const ph::matrix<double, 2, 2> E{{k % 5 - 2.0, k / 5 % 5 - 2.0}, {k / 25 % 5 - 2.0, k / 125 - 2.0}};
    for (const force& n : {force(1, 0), force(-1, 0), force(0, 1), force(0.6, 0.8), force(-0.6, 0.8)})
      expect_figure_3(unit * E, n);
  }
}

TEST(approximation, scales_with_its_force) {
  const ph::matrix<double, 2, 2> E{{2, 1}, {0, 3}};
  const auto F = ph::approximate(E, force(1, -1), force(0.6, 0.8), 0.0), doubled = 2.0 * F;
  EXPECT_EQ(F.display, ph::display_class::approximate);
  EXPECT_TRUE(F.force.isApprox(force(0, 1.25), 1e-15)) << F.force.transpose();
  EXPECT_TRUE(F.torque.isApprox(force(0, 3.75), 1e-15)) << F.torque.transpose();
  EXPECT_NEAR(F.cosine(), 0.8, 1e-15);
  EXPECT_EQ(doubled.display, F.display);
  EXPECT_EQ(doubled.force, 2 * F.force);
  EXPECT_EQ(doubled.torque, 2 * F.torque);
  EXPECT_EQ(doubled.cosine_squared, F.cosine_squared);
}

// Where the nearest force is 0 there is nothing to make longer.
TEST(approximation, is_none_at_a_right_angle_even_if_any_angle_will_do) {
  const auto expect_none = [](const auto& F) {
    EXPECT_EQ(F.display, ph::display_class::none);
    EXPECT_TRUE(F.force.isZero(0) && F.torque.isZero(0));
    EXPECT_EQ(F.cosine_squared, 0);
  };
  const auto axes = ph::identity_matrix<double, 2>();
  for (const double s_1 : {-1.0, 1.0}) expect_none(ph::approximate(axes, force(1, s_1), force(1, 0), 0.0));
  const ph::matrix<double, 2, 3> E{{1, 0, 1}, {0, 1, 1}};
  expect_none(ph::approximate(E, three(1, 1, 1), force(0.6, 0.8), 0.0));
}

TEST(approximation, in_space_gives_no_torque_at_all_to_a_released_brake) {
  ph::testing::random_source random(2);
  int released = 0;
  for (int k = 0; k < 100; ++k) {
    ph::matrix<double, 3, 3> E;
    for (int i = 0; i < 3; ++i) E.col(i) = random.direction<double, 3>();
    const three s(k % 2 * 2 - 1, 1, -1), n = random.direction<double, 3>();
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

TEST(cosine_squared, is_zero_from_a_right_angle_on) {
  const force n(1, 0);
  EXPECT_DOUBLE_EQ(ph::cosine_squared(force(3, 4), n), 0.36);
  EXPECT_DOUBLE_EQ(ph::cosine_squared(force(3e-200, 4e-200), n), 0.36);
  EXPECT_EQ(ph::cosine_squared(force(0, 4), n), 0);
  EXPECT_EQ(ph::cosine_squared(force(-3, 4), n), 0);
  EXPECT_EQ(ph::cosine_squared(force(0, 0), n), 0);
  EXPECT_EQ(ph::cosine_squared(force(std::numeric_limits<double>::quiet_NaN(), 0), n), 0);
}

TEST(approximation, of_axes_of_which_some_are_off_leaves_the_others) {
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

}  // namespace
