// slow
// Friction of several brakes at once, against every combination of stick and slip.
#include <passive_haptics/core/scalar/first_order_lag.hpp>
#include <passive_haptics/plant/box_friction.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>
#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace ph = passive_haptics;

namespace {

template <class Scalar, int Size>
struct brakes {
  using T = Scalar;
  static constexpr int m = Size;
};

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// Solves [K | rhs] by Gauss-Jordan with pivoting.
std::vector<double> solve(std::vector<std::vector<double>> rows) {
  const std::size_t n = rows.size();
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = k + 1; i < n; ++i) {
      if (std::abs(rows[i][k]) > std::abs(rows[k][k])) std::swap(rows[i], rows[k]);
    }
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      const double factor = rows[i][k] / rows[k][k];
      for (std::size_t j = k; j <= n; ++j) rows[i][j] -= factor * rows[k][j];
    }
  }
  std::vector<double> x;
  for (std::size_t k = 0; k < n; ++k) x.push_back(rows[k][n] / rows[k][k]);
  return x;
}

template <class Brakes>
struct box_friction : ::testing::Test {
  using number = typename Brakes::T;
  static constexpr int m = Brakes::m;
  using vec = ph::vector<number, m>;
  using mat = ph::matrix<number, m, m>;

  // The mode of brake i: 0 sticks, 1 slips with p = +limit, 2 with p = -limit.
  static int mode(int combination, int i) {
    for (; i > 0; --i) combination /= 3;
    return combination % 3;
  }

  // The impulse that violates the laws of friction least, of all 3^m combinations.
  static std::vector<double> by_enumeration(const mat& A, const vec& w0, const vec& limit) {
    std::vector<double> best;
    double least = std::numeric_limits<double>::infinity();
    for (int c = 0; c < static_cast<int>(std::pow(3, m)); ++c) {
      std::vector<std::vector<double>> rows;  // of [K | rhs]: w_i = 0 or p_i at its bound
      for (int i = 0; i < m; ++i) {
        std::vector<double> row(m + 1, 0.0);
        for (int j = 0; j < m; ++j) row[at(j)] = mode(c, i) == 0 ? A(i, j) : (i == j ? 1 : 0);
        row[m] = mode(c, i) == 0 ? -w0[i] : (mode(c, i) == 1 ? limit[i] : -limit[i]);
        rows.push_back(row);
      }
      const std::vector<double> p = solve(rows);
      double violation = 0;
      for (int i = 0; i < m; ++i) {
        double w = w0[i];
        for (int j = 0; j < m; ++j) w += static_cast<double>(A(i, j)) * p[at(j)];
        const double over = mode(c, i) == 0 ? std::abs(p[at(i)]) - limit[i] : (mode(c, i) == 1 ? w : -w);
        violation = std::max(violation, over);
      }
      if (violation < least) {
        least = violation;
        best = p;
      }
    }
    return best;
  }

  static void check(const mat& A, const vec& w0, const vec& limit) {
    SCOPED_TRACE(::testing::Message()
                 << "A =\n"
                 << A << "\nw0 = " << w0.transpose() << "\nlimit = " << limit.transpose());
    const auto result = ph::solve_box_friction<number, m>(A, w0, limit);
    ASSERT_TRUE(result.solved);
    const vec w = w0 + A * result.impulse;
    const number rounding = ph::rounding_tolerance<number>(4 * m) * (w0.norm() + A.norm() * limit.norm());
    for (int i = 0; i < m; ++i) {
      EXPECT_LE(std::abs(result.impulse[i]), limit[i]);
      const bool sticks = result.sticks[at(i)];
      if (sticks) {
        EXPECT_LE(std::abs(w[i]), rounding) << "brake " << i << " sticks";
      } else {
        EXPECT_EQ(std::abs(result.impulse[i]), limit[i]) << "brake " << i << " slips";
        EXPECT_LE(result.impulse[i] * w[i], rounding * limit[i]) << "brake " << i << " would drive";
      }
    }
    const std::vector<double> expected = by_enumeration(A, w0, limit);
    for (int i = 0; i < m; ++i) {  // |A^-1| <= 20
      EXPECT_NEAR(result.impulse[i], expected[at(i)], 20 * static_cast<double>(rounding)) << "brake " << i;
    }
  }
};

using sizes = ::testing::Types<brakes<float, 2>, brakes<double, 1>, brakes<double, 2>, brakes<double, 3>,
                               brakes<double, 4>>;
TYPED_TEST_SUITE(box_friction, sizes);

template <class Fixture>
typename Fixture::mat positive_definite(ph::testing::random_source& random) {
  using T = typename Fixture::number;
  typename Fixture::mat L;
  for (int j = 0; j < Fixture::m; ++j) L.col(j) = random.normal_vector<T, Fixture::m>();
  return L * L.transpose() + T(0.05) * Fixture::mat::Identity();  // so |A^-1| <= 20
}

TYPED_TEST(box_friction, agrees_with_the_enumeration_of_all_modes) {
  using T = typename TestFixture::number;
  ph::testing::random_source random(31);
  int sticking = 0, slipping = 0;
  for (int k = 0; k < 150; ++k) {
    const auto A = positive_definite<TestFixture>(random);
    const auto w0 = random.normal_vector<T, TestFixture::m>();
    typename TestFixture::vec limit;
    for (int i = 0; i < TestFixture::m; ++i)
      limit[i] = k % 5 == 0 && i == 0 ? T(0) : random.positive(T(0.03), T(10));
    SCOPED_TRACE(::testing::Message() << "seed 31, trial " << k);
    this->check(A, w0, limit);
    const auto result = ph::solve_box_friction<T, TestFixture::m>(A, w0, limit);
    for (const bool s : result.sticks) ++(s ? sticking : slipping);
  }
  EXPECT_GT(sticking, 10);
  EXPECT_GT(slipping, 10);
}

TYPED_TEST(box_friction, strong_brakes_stop_everything_and_absent_ones_nothing) {
  using T = typename TestFixture::number;
  using V = typename TestFixture::vec;
  ph::testing::random_source random(32);
  const auto A = positive_definite<TestFixture>(random);
  const V w0 = random.normal_vector<T, TestFixture::m>();
  const auto strong = ph::solve_box_friction<T, TestFixture::m>(A, w0, V::Constant(T(1e6)));
  for (const bool s : strong.sticks) EXPECT_TRUE(s);
  EXPECT_LE((w0 + A * strong.impulse).norm(),
            ph::rounding_tolerance<T>(8) * A.norm() * strong.impulse.norm());
  const auto absent = ph::solve_box_friction<T, TestFixture::m>(A, w0, V(V::Zero()));
  for (const bool s : absent.sticks) EXPECT_FALSE(s);
  EXPECT_TRUE(absent.impulse.isZero(T(0)));
}

TYPED_TEST(box_friction, at_rest_nothing_happens) {
  using T = typename TestFixture::number;
  using V = typename TestFixture::vec;
  ph::testing::random_source random(33);
  const auto result = ph::solve_box_friction<T, TestFixture::m>(positive_definite<TestFixture>(random),
                                                                V(V::Zero()), V(V::Ones()));
  EXPECT_TRUE(result.impulse.isZero(T(0)));
}

// m brakes on n joints: A = B B^T has rank n.
template <class T, int N, int Brakes>
void check_redundant(unsigned seed) {
  ph::testing::random_source random(seed);
  int sticking = 0, slipping = 0;
  for (int k = 0; k < 300; ++k) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed << ", trial " << k);
    ph::matrix<T, Brakes, N> B;
    for (int j = 0; j < N; ++j) B.col(j) = random.normal_vector<T, Brakes>();
    const ph::matrix<T, Brakes, Brakes> A = B * B.transpose();
    const ph::vector<T, Brakes> w0 = B * random.normal_vector<T, N>();
    ph::vector<T, Brakes> limit;
    for (int i = 0; i < Brakes; ++i) limit[i] = k % 5 == 0 && i == 0 ? T(0) : random.positive(T(0.03), T(10));
    const auto result = ph::solve_redundant_box_friction<T, Brakes>(A, w0, limit);
    ASSERT_TRUE(result.solved);
    // These laws are those of a convex program's solution: w is right if they hold
    const ph::vector<T, Brakes> w = w0 + A * result.impulse;
    const T rounding = ph::rounding_tolerance<T>(16 * Brakes) * (w0.norm() + A.norm() * limit.norm());
    for (int i = 0; i < Brakes; ++i) {
      EXPECT_LE(std::abs(result.impulse[i]), limit[i]);
      EXPECT_LE(result.impulse[i] * w[i], rounding * limit[i]) << "brake " << i << " would drive";
      if (std::abs(w[i]) <= rounding) {
        ++sticking;
      } else {
        EXPECT_EQ(std::abs(result.impulse[i]), limit[i]) << "brake " << i << " slips at " << w[i];
        ++slipping;
      }
    }
  }
  EXPECT_GT(sticking, 30);
  EXPECT_GT(slipping, 30);
}

TEST(redundant_box_friction, fulfils_the_laws_of_friction) {
  check_redundant<double, 2, 3>(41);
  check_redundant<double, 2, 4>(42);
  check_redundant<double, 3, 6>(43);
  check_redundant<float, 2, 3>(44);
  check_redundant<float, 2, 4>(45);
}

TEST(redundant_box_friction, holds_with_nearly_the_least_impulse) {
  ph::testing::random_source random(46);
  ph::matrix<double, 4, 2> B;
  for (int j = 0; j < 2; ++j) B.col(j) = random.normal_vector<double, 4>();
  const ph::matrix<double, 4, 4> A = B * B.transpose();
  const ph::vector<double, 2> v(0.3, -0.7);
  const auto result =
      ph::solve_redundant_box_friction<double, 4>(A, B * v, ph::vector<double, 4>::Constant(1e3));
  const ph::vector<double, 4> least = -B * (B.transpose() * B).ldlt().solve(v);
  EXPECT_LE((result.impulse - least).norm(), 1e-6 * least.norm());
}

template <class T>
struct lag : ::testing::Test {};
using lag_scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(lag, lag_scalars);

TYPED_TEST(lag, step_response_is_exponential_for_any_time_step) {
  using T = TypeParam;
  using V = ph::vector<T, 2>;
  for (const T dt : {T(1e-4), T(3e-3), T(0.1)}) {
    ph::first_order_lag<T, 2> brake(V(T(0.02), T(0.05)));
    EXPECT_TRUE(brake.output().isZero(T(0)));
    for (int k = 1; k <= 40; ++k) {
      const V y = brake.advance(dt, V(1, -2));
      const T t = dt * static_cast<T>(k);
      EXPECT_NEAR(y[0], T(1) - std::exp(-t / T(0.02)), ph::rounding_tolerance<T>(40));
      EXPECT_NEAR(y[1], T(-2) * (T(1) - std::exp(-t / T(0.05))), ph::rounding_tolerance<T>(80));
      EXPECT_EQ(brake.output(), y);
    }
  }
}

TYPED_TEST(lag, time_constant_zero_follows_at_once) {
  using T = TypeParam;
  ph::first_order_lag<T, 1> brake(ph::vector<T, 1>(T(0)));
  for (const T u : {T(3), T(0.1), T(-7e5), T(1) / T(3)})
    EXPECT_EQ(brake.advance(T(1e-6), ph::vector<T, 1>(u))[0], u);
}

TYPED_TEST(lag, corner_frequency_of_200_hz_is_a_lag_of_0_8_ms) {
  EXPECT_NEAR(ph::low_pass_time_constant(TypeParam(200)), TypeParam(7.9577e-4), TypeParam(1e-8));
}

}  // namespace
