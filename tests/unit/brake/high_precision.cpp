// slow, no sanitizers
// Kinematics, E and reference forces of the tendon device against the same formulas in 50 digits.
#include "../support.hpp"

#include <passive_haptics/brake/reference_forces.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <boost/multiprecision/cpp_bin_float.hpp>

namespace {

using boost::multiprecision::cpp_bin_float_50;

// x, J, E = J T^-1 and G = E^-T, column by column, from the drawing (Fig. 7).
struct reference {
  cpp_bin_float_50 x[2], J[2][2], E[2][2], G[2][2], det;

  template <class T>
  reference(const ph::tendon_two_link_parameters<T>& p, const ph::vector<T, 2>& q) {
    const cpp_bin_float_50 l1 = p.length_1, l2 = p.length_2, k2 = p.reduction_2;
    const cpp_bin_float_50 q1 = q[0], q12 = cpp_bin_float_50(q[0]) + cpp_bin_float_50(q[1]);
    x[0] = l1 * cos(q1) + l2 * cos(q12);
    x[1] = l1 * sin(q1) + l2 * sin(q12);
    J[0][0] = -x[1];
    J[1][0] = x[0];
    J[0][1] = -l2 * sin(q12);
    J[1][1] = l2 * cos(q12);
    for (int r = 0; r < 2; ++r) {  // T^-1 = [1 0; -k2 k2]
      E[r][0] = J[r][0] - k2 * J[r][1];
      E[r][1] = k2 * J[r][1];
    }
    det = E[0][0] * E[1][1] - E[0][1] * E[1][0];
    G[0][0] = E[1][1] / det;
    G[0][1] = -E[1][0] / det;
    G[1][0] = -E[0][1] / det;
    G[1][1] = E[0][0] / det;
  }
};

template <class T>
void expect_matrix(const ph::matrix<T, 2, 2>& actual, const cpp_bin_float_50 (&expected)[2][2],
                   double bound) {
  for (int r = 0; r < 2; ++r) {
    for (int c = 0; c < 2; ++c) {
      const cpp_bin_float_50 error = abs(cpp_bin_float_50(actual(r, c)) - expected[r][c]);
      EXPECT_LE(static_cast<double>(error), bound) << "row " << r << ", column " << c;
    }
  }
}

template <class T>
struct high_precision : ::testing::Test {};
TYPED_TEST_SUITE(high_precision, scalars);

TYPED_TEST(high_precision, tendon_device_agrees_with_50_digits) {
  using T = TypeParam;
  const ph::tendon_two_link_parameters<T> p;
  const ph::tendon_two_link<T> arm(p);
  ph::testing::random_source random(3);
  for (int k = 0; k < 300; ++k) {
    const ph::vector<T, 2> q = random.between<T, 2>({-3, -3}, {3, 3});
    SCOPED_TRACE(::testing::Message() << "seed 3, q = " << q.transpose());
    const reference r(p, q);
    // Rounding of angles up to 6 rad, of lengths up to 0.3 m
    const double rounding = static_cast<double>(ph::rounding_tolerance<T>(2)) * 6 * 0.3;
    const ph::vector<T, 2> x = arm.position(q);
    for (int i = 0; i < 2; ++i) EXPECT_NEAR(static_cast<double>(x[i]), static_cast<double>(r.x[i]), rounding);
    expect_matrix<T>(ph::jacobian(arm, q), r.J, rounding);
    expect_matrix<T>(ph::brake_jacobian(arm, q), r.E, 2 * rounding);
    const auto forces = ph::reference_forces(arm, q);
    ASSERT_EQ(forces.outcome, ph::status::ok);
    const double size = static_cast<double>(forces.G.norm());  // |dG| <= |G|^2 |dE|
    expect_matrix<T>(forces.G, r.G, 4 * rounding * size * size);
  }
}

}  // namespace
