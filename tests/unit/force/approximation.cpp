// Nearest forces and approximations of two brakes by hand: axes alone, right angles and the largest angle.
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

// Fc . n = 1 along the nearest force, the torques those of Fc and of the right signs exactly; none beyond the
// largest angle.
template <class EMatrix>
void expect_nearest_scaled(const EMatrix& E, const force& s, const force& n, double min_cosine) {
  const ph::matrix<double, 2, 2> dense(E);
  SCOPED_TRACE(::testing::Message() << "E =\n"
                                    << dense << "\ns = " << s.transpose() << ", n = " << n.transpose());
  const auto F = ph::approximate(E, s, n, min_cosine);
  const force Fp = ph::nearest_force(E, s, n).force;
  const double cosine = Fp.norm();
  if ((Fp - n).norm() < 1e-12) {
    EXPECT_EQ(F.display, ph::display_class::exact);
    EXPECT_EQ(F.force, n);
    EXPECT_EQ(F.cosine_squared, 1);
  } else if (cosine >= min_cosine) {
    EXPECT_EQ(F.display, ph::display_class::approximate);
    EXPECT_NEAR(F.force.dot(n), 1, 1e-12 / cosine);
    EXPECT_LE((F.force - Fp / Fp.squaredNorm()).norm(), 1e-12 / cosine);
    EXPECT_NEAR(F.cosine_squared, cosine * cosine, 1e-12);
    EXPECT_NEAR(F.cosine(), cosine, 1e-12);
    EXPECT_NEAR(ph::cosine_squared(F.force, n), cosine * cosine, 1e-12);
  } else {
    EXPECT_EQ(F.display, ph::display_class::none);
    EXPECT_TRUE(F.force.isZero(0) && F.torque.isZero(0));
    EXPECT_EQ(F.cosine_squared, 0);
  }
  EXPECT_LE((F.torque - dense.transpose() * F.force).norm(), 1e-12 * dense.norm() * F.force.norm());
  EXPECT_LE((s.cwiseProduct(F.torque)).maxCoeff(), 0);
}

TEST(approximation, of_two_brakes_is_the_nearest_force_made_longer) {
  ph::testing::random_source random(1);
  for (int k = 0; k < 500; ++k) {
    ph::matrix<double, 2, 2> E;
    for (int i = 0; i < 2; ++i) E.col(i) = random.positive(0.2, 5.0) * random.direction<double, 2>();
    if (std::abs(E(0, 0) * E(1, 1) - E(0, 1) * E(1, 0)) < 1e-2) continue;
    const force s(k % 3 - 1, k / 3 % 3 - 1), n = random.direction<double, 2>();
    const double min_cosine = k % 2 == 0 ? 0.02 : 0.7;
    expect_nearest_scaled(E, s, n, min_cosine);
    expect_nearest_scaled(ph::diagonal_matrix<double, 2>(E(0, 0), E(1, 1)), s, n, min_cosine);
  }
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

TEST(approximation, of_two_brakes_is_that_of_figure_3) {
  ph::testing::random_source random(3);
  for (int k = 0; k < 1000; ++k) {
    ph::matrix<double, 2, 2> E;
    for (double& x : E.reshaped()) x = random.normal<double>();
    expect_figure_3(E, random.direction<double, 2>());
  }
}

// Small whole numbers give columns that are 0, parallel, opposed and at right angles to the force.
TEST(approximation, of_two_brakes_at_the_edges_is_that_of_figure_3) {
  for (int k = 0; k < 5 * 5 * 5 * 5; ++k) {
    const double unit = k % 3 == 0 ? 1 : (k % 3 == 1 ? 1e-50 : 1e50);
    const ph::matrix<double, 2, 2> E{{k % 5 - 2.0, k / 5 % 5 - 2.0}, {k / 25 % 5 - 2.0, k / 125 - 2.0}};
    for (const force& n : {force(1, 0), force(-1, 0), force(0, 1), force(0.6, 0.8), force(-0.6, 0.8)})
      expect_figure_3(unit * E, n);
  }
}

// Whichever brakes hold it, what is left is across both, and asks for no torque.
TEST(approximation, of_two_brakes_that_pull_along_one_line_needs_no_torque) {
  const ph::matrix<double, 2, 2> E{{1, 2}, {1, 2}};
  for (const force& s : {force(1, 1), force(1, -1), force(-1, 1)}) {
    const auto F = ph::approximate(E, s, force(0.6, 0.8), 0.02);
    EXPECT_EQ(F.display, ph::display_class::approximate) << s.transpose();
    EXPECT_EQ(F.torque, force(0, 0)) << s.transpose();
    EXPECT_TRUE(F.force.isApprox(5 * force(-1, 1), 1e-14)) << F.force.transpose();
  }
  EXPECT_EQ(ph::approximate(E, force(-1, -1), force(0.6, 0.8), 0.02).display, ph::display_class::exact);
}

TEST(approximation, scales_with_its_force) {
  const ph::matrix<double, 2, 2> E{{2, 1}, {0, 3}};
  const auto F = ph::approximate(E, force(1, -1), force(0.6, 0.8), 0.0), doubled = 2.0 * F;
  EXPECT_EQ(F.display, ph::display_class::approximate);
  EXPECT_TRUE(F.force.isApprox(force(0, 1.25), 1e-15)) << F.force.transpose();
  EXPECT_TRUE(F.torque.isApprox(force(0, 3.75), 1e-15)) << F.torque.transpose();
  EXPECT_EQ(doubled.display, F.display);
  EXPECT_EQ(doubled.force, 2 * F.force);
  EXPECT_EQ(doubled.torque, 2 * F.torque);
  EXPECT_EQ(doubled.cosine_squared, F.cosine_squared);
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

TEST(classification, by_power_and_by_each_brake) {
  using ph::power_class;
  for (const bool alone : {false, true}) EXPECT_EQ(ph::classify_power(1e-300, alone), power_class::active);
  for (const double power : {0.0, -2.0}) {
    EXPECT_EQ(ph::classify_power(power, true), power_class::passive_1);
    EXPECT_EQ(ph::classify_power(power, false), power_class::passive_2);
  }
  EXPECT_TRUE(ph::producible(three(-1, 0, 1), three(2, 5, -3)));
  EXPECT_TRUE(ph::producible(three(-1, 0, 1), three(0, -5, 0)));
  for (const three& t : {three(-2, 5, -3), three(2, 5, 3)}) EXPECT_FALSE(ph::producible(three(-1, 0, 1), t));
  EXPECT_FALSE(ph::producible(three(0, 1, 0), three(0, 1e-300, 0)));
  EXPECT_EQ(ph::mechanical_power(three(1, 2, 3), three(4, -5, 6)), 12);
}

TEST(classification, in_words) {
  EXPECT_EQ(to_string(ph::power_class::none), "none");
  EXPECT_EQ(to_string(ph::power_class::active), "active");
  EXPECT_EQ(to_string(ph::power_class::passive_1), "passive I");
  EXPECT_EQ(to_string(ph::power_class::passive_2), "passive II");
  EXPECT_EQ(to_string(ph::power_class(9)), "unknown power class");
  EXPECT_EQ(to_string(ph::display_class::none), "none");
  EXPECT_EQ(to_string(ph::display_class::approximate), "approximate");
  EXPECT_EQ(to_string(ph::display_class::exact), "exact");
  EXPECT_EQ(to_string(ph::display_class(9)), "unknown display class");
  EXPECT_TRUE(is_displayed(ph::display_class::exact) && is_displayed(ph::display_class::approximate));
  EXPECT_FALSE(is_displayed(ph::display_class::none));
}

}  // namespace
