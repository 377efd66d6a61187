// Least squares of least norm for matrices of any rank: by hand, and the conditions of Moore and Penrose.
#include <passive_haptics/core/linear/orthogonal_decomposition.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ph = passive_haptics;

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double tolerance = ph::rounding_tolerance<double>(8);

TEST(orthogonal_decomposition, of_nothing_has_no_rank_and_takes_nothing_away) {
  const ph::orthogonal_decomposition<double, 2, 3> none(ph::matrix<double, 2, 3>::Zero(), tolerance);
  const ph::vector<double, 3> g(1, -2, 3);
  const ph::vector<double, 2> b(4, 5);
  EXPECT_EQ(none.rank(), 0);
  EXPECT_TRUE(none.solve(b).isZero(0) && none.solve_transposed(g).isZero(0));
  EXPECT_EQ(none.without_row_space(g), g);
  EXPECT_EQ(none.without_column_space(b), b);
  EXPECT_EQ(none.left_null_projection(), (ph::identity_matrix<double, 2>()));
}

// Against the longest row, after the others were taken out of it.
TEST(orthogonal_decomposition, takes_what_is_shorter_than_its_tolerance_for_none) {
  const auto rank = [](double second) {
    const ph::matrix<double, 3, 2> A{{0.5, 0}, {4, second}, {-4, 0}};
    return ph::orthogonal_decomposition<double, 3, 2>(A, 0.25).rank();
  };
  EXPECT_EQ(rank(1.25), 2);
  EXPECT_EQ(rank(0.75), 1);
  EXPECT_EQ(rank(0), 1);
  EXPECT_EQ(
      (ph::orthogonal_decomposition<double, 2, 2>(ph::matrix<double, 2, 2>{{8, 0}, {0, 1}}, 0.25).rank()), 1);
}

TEST(orthogonalise, leaves_a_right_angle_where_little_is_left) {
  ph::matrix<double, 3, 2> Q{{0.6, 0}, {0.8, 0}, {0, 1}};
  ph::vector<double, 3> x(3, 4 + 1e-9, 7);
  const ph::vector<double, 2> parts = ph::orthogonalise(x, Q, 2);
  EXPECT_NEAR(parts[0], 5, 1e-8);
  EXPECT_EQ(parts[1], 7);
  EXPECT_NEAR(x[0], -0.48e-9, 1e-14);
  EXPECT_NEAR(x[1], 0.36e-9, 1e-14);
  EXPECT_LE(std::abs(Q.col(0).dot(x)), 4 * epsilon * x.norm());
  ph::testing::random_source random(3);
  for (int k = 0; k < 20; ++k) {
    const ph::matrix<double, 3, 1> q = random.direction<double, 3>();
    x = q + 1e-9 * random.direction<double, 3>();
    ph::orthogonalise(x, q, 1);
    EXPECT_LE(std::abs(q.col(0).dot(x)), 8 * epsilon * x.norm()) << "seed 3, trial " << k;
  }
  x = {1, 2, 3};
  EXPECT_EQ(ph::orthogonalise(x, Q, 0), (ph::vector<double, 2>(0, 0)));
  EXPECT_EQ(x, (ph::vector<double, 3>(1, 2, 3)));
  Q.col(0) = ph::vector<double, 3>(1, 0, 0);
  EXPECT_EQ(ph::orthogonalise(x, Q, 1), (ph::vector<double, 2>(1, 0))) << "the second is not asked";
  EXPECT_EQ(x, (ph::vector<double, 3>(0, 2, 3)));
}

// A product of random factors, of rank Rank.
template <int Rows, int N, int Rank>
void expect_pseudo_inverse() {
  SCOPED_TRACE(::testing::Message() << Rows << " x " << N << " of rank " << Rank);
  ph::testing::random_source random(1);
  for (int k = 0; k < 20; ++k) {
    ph::matrix<double, Rows, N> A = ph::matrix<double, Rows, N>::Zero();
    for (int r = 0; r < Rank; ++r)
      A += (r + 1) * random.direction<double, Rows>() * random.direction<double, N>().transpose();
    const ph::orthogonal_decomposition<double, Rows, N> factors(A, tolerance);
    ASSERT_EQ(factors.rank(), Rank);
    const ph::matrix<double, N, Rows> X = factors.pseudo_inverse();
    const double size = A.norm() * X.norm(), rounding = 64 * epsilon * (1 + size * size);
    EXPECT_LE((A * X * A - A).norm(), rounding * A.norm());
    EXPECT_LE((X * A * X - X).norm(), rounding * X.norm());
    EXPECT_LE((A * X - (A * X).transpose()).norm(), rounding);
    EXPECT_LE((X * A - (X * A).transpose()).norm(), rounding);

    const ph::vector<double, Rows> b = random.normal_vector<double, Rows>();
    const ph::vector<double, N> g = random.normal_vector<double, N>();
    const double long_b = rounding * X.norm() * b.norm(), long_g = rounding * X.norm() * g.norm();
    EXPECT_LE((factors.solve(b) - X * b).norm(), long_b);
    EXPECT_LE((factors.solve_transposed(g) - X.transpose() * g).norm(), long_g);
    ph::matrix<double, Rows, 2> two;
    two << b, 2 * b;
    EXPECT_EQ(factors.solve(two).col(1), factors.solve(ph::vector<double, Rows>(two.col(1))));
    EXPECT_LE((factors.without_row_space(g) - (g - X * A * g)).norm(), rounding * g.norm());
    EXPECT_LE((factors.without_column_space(b) - (b - A * X * b)).norm(), rounding * b.norm());
    const ph::matrix<double, Rows, Rows> left = ph::identity_matrix<double, Rows>() - A * X;
    EXPECT_LE((factors.left_null_projection() - left).norm(), rounding);
  }
}

TEST(orthogonal_decomposition, inverts_as_far_as_the_rank_goes) {
  expect_pseudo_inverse<5, 3, 2>();
  expect_pseudo_inverse<3, 4, 3>();
}

}  // namespace
