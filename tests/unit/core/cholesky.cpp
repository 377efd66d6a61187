// slow
#include <passive_haptics/core/finite.hpp>
#include <passive_haptics/core/linear/cholesky.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ph = passive_haptics;

namespace {

constexpr unsigned seed = 20040627;

// max |A X - B| over the terms of each entry [epsilon]; sums of twice the digits.
template <class T, int N, int C>
double backward_error(const ph::matrix<T, N, N>& A, const ph::matrix<T, N, C>& X,
                      const ph::matrix<T, N, C>& B) {
  long double worst = 0;
  for (int i = 0; i < N; ++i) {
    for (int c = 0; c < C; ++c) {
      long double residual = -B(i, c), size = std::abs(B(i, c));
      for (int k = 0; k < N; ++k) {
        const long double term = static_cast<long double>(A(i, k)) * X(k, c);
        residual += term;
        size += std::abs(term);
      }
      worst = std::max(worst, std::abs(residual) / size);
    }
  }
  return static_cast<double>(worst / std::numeric_limits<T>::epsilon());
}

// F F^T + I, its rows and columns of lengths over twelve powers of ten.
template <class T, int N>
ph::matrix<T, N, N> random_positive_definite(ph::testing::random_source& random) {
  ph::matrix<T, N, N> F, A;
  ph::vector<T, N> length;
  for (int i = 0; i < N; ++i) {
    length[i] = random.positive(T(1e-6), T(1e6));
    for (int j = 0; j < N; ++j) F(i, j) = random.uniform(T(-1), T(1));
  }
  for (int i = 0; i < N; ++i) {
    for (int j = 0; j < N; ++j) A(i, j) = (F.row(i).dot(F.row(j)) + T(i == j)) * (length[i] * length[j]);
  }
  return A;
}

template <class T, int N>
void expect_solutions() {
  SCOPED_TRACE(N);
  ph::testing::random_source random(seed);
  const T epsilon = std::numeric_limits<T>::epsilon();
  for (int trial = 0; trial < 200; ++trial) {
    const auto A = random_positive_definite<T, N>(random);
    ph::matrix<T, N, 2> B;
    for (int i = 0; i < N; ++i) B.row(i) << random.uniform(T(-1), T(1)), random.uniform(T(-1), T(1));

    const ph::cholesky<T, N> factors(A);
    const ph::matrix<T, N, 2> X = factors.solve(B), half = factors.half_solve(B);
    EXPECT_LT(backward_error(A, X, B), 2 * N) << A << "\n\n" << B;
    for (int c = 0; c < 2; ++c) {
      const T ratio = half.col(c).squaredNorm() / B.col(c).dot(X.col(c));
      EXPECT_LT(std::abs(ratio - 1), 100 * epsilon) << A << "\n\n" << B;
    }
    const ph::vector<T, N> x = X.col(0);
    EXPECT_LT(std::abs(factors.half_product(x).squaredNorm() / x.dot(A * x) - 1), T(1e4) * epsilon) << A;
  }
}

TEST(cholesky, solves_what_its_rounding_allows_for_rows_of_any_length) {
  expect_solutions<double, 3>();
  expect_solutions<float, 7>();
}

TEST(cholesky, leaves_the_unknown_of_a_zero_pivot_at_zero) {
  ph::matrix<double, 3, 3> A = ph::matrix<double, 3, 3>::Ones();
  A(2, 2) = 5;
  for (const double second : {3.0, 4.0}) {
    const ph::vector<double, 3> x = ph::cholesky<double, 3>(A).solve(ph::vector<double, 3>(3, second, 7));
    EXPECT_EQ(x, (ph::vector<double, 3>(2, 0, 1))) << second;
  }
}

TEST(cholesky, keeps_a_nan_beside_a_zero_pivot) {
  ph::matrix<double, 2, 2> A = ph::matrix<double, 2, 2>::Identity();
  A(0, 0) = 0;
  A(1, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(ph::all_finite(ph::cholesky<double, 2>(A).solve(ph::vector<double, 2>(1, 1))));
}

// The upper triangle is not read.
TEST(cholesky, of_what_is_not_positive_definite_has_no_finite_half) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const ph::vector<double, 3> ones = ph::vector<double, 3>::Ones();
  ph::matrix<double, 3, 3> A = ph::identity_matrix<double, 3>();
  A(0, 1) = nan;
  EXPECT_TRUE((ph::cholesky<double, 3>(A).is_positive_definite()));
  EXPECT_EQ((ph::cholesky<double, 3>(A).solve(ones)), ones);
  for (const double bad : {-1.0, 0.0, nan}) {
    for (int i = 0; i < 3; ++i) {
      auto B = A;
      B(i, i) = bad;
      const ph::cholesky<double, 3> factors(B);
      EXPECT_FALSE(factors.is_positive_definite()) << bad << " at " << i;
      EXPECT_FALSE(std::isfinite(factors.half_solve(ones)[i])) << bad << " at " << i;
      EXPECT_EQ(std::isnan(factors.solve(ones)[i]), std::isnan(bad)) << bad << " at " << i;
    }
  }
}

}  // namespace
