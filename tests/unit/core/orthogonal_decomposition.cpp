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

// One size in all tests: the compiler takes a second for each.
using tall = ph::matrix<double, 4, 3>;
using decomposition = ph::orthogonal_decomposition<double, 4, 3>;
using four = ph::vector<double, 4>;
using three = ph::vector<double, 3>;

TEST(orthogonal_decomposition, of_nothing_has_no_rank_and_takes_nothing_away) {
  const decomposition none(tall::Zero(), tolerance);
  const three g(1, -2, 3);
  const four b(4, 5, 6, 7);
  EXPECT_EQ(none.rank(), 0);
  EXPECT_TRUE(none.solve(b).isZero(0) && none.solve_transposed(g).isZero(0));
  EXPECT_EQ(none.without_row_space(g), g);
  EXPECT_EQ(none.without_column_space(b), b);
  EXPECT_EQ(none.left_null_projection(), (ph::identity_matrix<double, 4>()));
}

// Against the longest row, after the others were taken out of it.
TEST(orthogonal_decomposition, takes_what_is_shorter_than_its_tolerance_for_none) {
  const auto rank = [](double second) {
    const tall A{{0.5, 0, 0}, {4, second, 0}, {-4, 0, 0}, {0, 0, 0}};
    return decomposition(A, 0.25).rank();
  };
  EXPECT_EQ(rank(1.25), 2);
  EXPECT_EQ(rank(0.75), 1);
  EXPECT_EQ(rank(0), 1);
}

TEST(orthogonalise, leaves_a_right_angle_where_little_is_left) {
  ph::matrix<double, 3, 2> Q{{0.6, 0}, {0.8, 0}, {0, 1}};
  three x(3, 4 + 1e-9, 7);
  const ph::vector<double, 2> parts = ph::orthogonalise(x, Q, 2);
  EXPECT_NEAR(parts[0], 5, 1e-8);
  EXPECT_EQ(parts[1], 7);
  EXPECT_NEAR(x[0], -0.48e-9, 1e-14);
  EXPECT_NEAR(x[1], 0.36e-9, 1e-14);
  EXPECT_LE(std::abs(Q.col(0).dot(x)), 4 * epsilon * x.norm());
  ph::testing::random_source random(3);
  for (int k = 0; k < 20; ++k) {
    Q.col(0) = random.direction<double, 3>();
    x = Q.col(0) + 1e-9 * random.direction<double, 3>();
    ph::orthogonalise(x, Q, 1);
    EXPECT_LE(std::abs(Q.col(0).dot(x)), 8 * epsilon * x.norm()) << "seed 3, trial " << k;
  }
  x = {1, 2, 3};
  EXPECT_EQ(ph::orthogonalise(x, Q, 0), (ph::vector<double, 2>(0, 0)));
  EXPECT_EQ(x, three(1, 2, 3));
  Q.col(0) = three(1, 0, 0);
  EXPECT_EQ(ph::orthogonalise(x, Q, 1), (ph::vector<double, 2>(1, 0))) << "the second is not asked";
  EXPECT_EQ(x, three(0, 2, 3));
}

// One difference for each size, which takes the compiler less time than an expression for each use.
template <int Rows, int N>
void expect_close(const ph::matrix<double, Rows, N>& a, const ph::matrix<double, Rows, N>& b,
                  double distance) {
  const ph::matrix<double, Rows, N> apart = a - b;
  EXPECT_LE(apart.norm(), distance);
}

// Sums of random products: the conditions of Moore and Penrose.
TEST(orthogonal_decomposition, inverts_as_far_as_the_rank_goes) {
  using square = ph::matrix<double, 3, 3>;
  using large_square = ph::matrix<double, 4, 4>;
  ph::testing::random_source random(1);
  for (int k = 0; k < 60; ++k) {
    const int rank = 1 + k % 3;
    SCOPED_TRACE(::testing::Message() << "seed 1, trial " << k << ", rank " << rank);
    tall A = tall::Zero();
    for (int r = 0; r < rank; ++r)
      A += (r + 1) * random.direction<double, 4>() * random.direction<double, 3>().transpose();
    const decomposition factors(A, tolerance);
    ASSERT_EQ(factors.rank(), rank);
    const ph::matrix<double, 3, 4> X = factors.pseudo_inverse();
    const large_square AX = A * X;
    const square XA = X * A;
    const double size = A.norm() * X.norm(), rounding = 64 * epsilon * (1 + size * size);
    expect_close<4, 3>(AX * A, A, rounding * A.norm());
    expect_close<3, 4>(XA * X, X, rounding * X.norm());
    expect_close<4, 4>(AX, AX.transpose(), rounding);
    expect_close<3, 3>(XA, XA.transpose(), rounding);

    const four b = random.normal_vector<double, 4>();
    const three g = random.normal_vector<double, 3>();
    const double long_b = rounding * X.norm() * b.norm(), long_g = rounding * X.norm() * g.norm();
    expect_close<3, 1>(factors.solve(b), X * b, long_b);
    expect_close<4, 1>(factors.solve_transposed(g), X.transpose() * g, long_g);
    expect_close<3, 1>(factors.without_row_space(g), g - XA * g, rounding * g.norm());
    expect_close<4, 1>(factors.without_column_space(b), b - AX * b, rounding * b.norm());
    expect_close<4, 4>(factors.left_null_projection(), ph::identity_matrix<double, 4>() - AX, rounding);
  }
}

}  // namespace
