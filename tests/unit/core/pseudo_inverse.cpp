// slow
// Least squares of least norm for matrices of any rank: the conditions of Moore and Penrose.
#include <passive_haptics/core/linear/orthogonal_decomposition.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

#include <limits>

namespace ph = passive_haptics;

namespace {

// A product of random factors, of rank Rank.
template <int Rows, int N, int Rank>
void expect_pseudo_inverse() {
  SCOPED_TRACE(::testing::Message() << Rows << " x " << N << " of rank " << Rank);
  constexpr double tolerance = ph::rounding_tolerance<double>(8);
  ph::testing::random_source random(1);
  for (int k = 0; k < 20; ++k) {
    ph::matrix<double, Rows, N> A = ph::matrix<double, Rows, N>::Zero();
    for (int r = 0; r < Rank; ++r)
      A += (r + 1) * random.direction<double, Rows>() * random.direction<double, N>().transpose();
    const ph::orthogonal_decomposition<double, Rows, N> factors(A, tolerance);
    ASSERT_EQ(factors.rank(), Rank);
    const ph::matrix<double, N, Rows> X = factors.pseudo_inverse();
    const double size = A.norm() * X.norm(),
                 rounding = 64 * std::numeric_limits<double>::epsilon() * (1 + size * size);
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
