// slow, no sanitizers
// However ill-conditioned the cone: the nearest force is within 8 roundings of each half-space, and as exact
// as its condition allows; of two half-spaces in the plane and three in space, which have closed forms, exact
// to rounding. More problems with PASSIVE_HAPTICS_STRESS=full.
#include "../../stress/effort.hpp"
#include "adversarial_cones.hpp"
#include "cone_oracle.hpp"

#include <passive_haptics/core/linear/cone.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace ph = passive_haptics;

namespace {

template <class T>
constexpr double eps = static_cast<double>(std::numeric_limits<T>::epsilon());

// Half-spaces { p : B^T p <= 0 } by the columns of B.
template <class Scalar, int Rows, int Columns>
struct size {
  using T = Scalar;
  static constexpr int rows = Rows, columns = Columns;
};

template <class Size>
struct adversarial_cone : ::testing::Test {};

// Closed forms and the active set, below and beyond as many half-spaces as dimensions
using adversarial_sizes =
    ::testing::Types<size<double, 2, 2>, size<double, 2, 4>, size<double, 3, 3>, size<double, 3, 7>,
                     size<double, 6, 6>, size<float, 3, 3>, size<float, 4, 4>>;
TYPED_TEST_SUITE(adversarial_cone, adversarial_sizes);

TYPED_TEST(adversarial_cone, holds_the_nearest_force_to_8_roundings_from_any_start) {
  using T = typename TypeParam::T;
  constexpr int R = TypeParam::rows, C = TypeParam::columns;
  const std::uint64_t seed = stress::first_seed(), count = stress::effort(2000, 650000);
  adversarial::cones<T, R, C> cones(seed);
  ph::half_space_set of_another = 0;
  for (std::uint64_t k = 0; k < count; ++k) {
    const auto [B, f] = cones.draw();
    ph::half_space_start start;
    const auto cold = ph::project_onto_half_spaces(B, f, start);
    start.active = of_another;
    for (const auto& result : {cold, ph::project_onto_half_spaces(B, f, start)}) {
      const double outside = adversarial::violation<T, R, C>(B, result.point);
      ASSERT_LE(outside, 8 * eps<T>) << "seed " << seed << ", problem " << k << ", start " << of_another
                                     << "\nB =\n"
                                     << B << "\nf = " << f.transpose();
      of_another = result.active;
    }
  }
}

// Of columns of length 1; infinite where one is zero.
template <class T, int R, int C>
double condition(const ph::matrix<T, R, C>& B) {
  ph::matrix<long double, R, C> unit = B.template cast<long double>();
  for (int j = 0; j < C; ++j) unit.col(j) /= unit.col(j).norm();
  const auto values = Eigen::JacobiSVD<ph::matrix<long double, R, C>>(unit).singularValues();
  const double condition = static_cast<double>(values[0] / values[std::min(R, C) - 1]);
  return std::isfinite(condition) ? condition : HUGE_VAL;
}

template <class Size>
struct adversarial_cone_in_50_digits : ::testing::Test {};

using square_sizes =
    ::testing::Types<size<double, 2, 2>, size<double, 3, 3>, size<double, 5, 5>, size<float, 3, 3>>;
TYPED_TEST_SUITE(adversarial_cone_in_50_digits, square_sizes);

TYPED_TEST(adversarial_cone_in_50_digits, is_exact_to_rounding_in_closed_form_else_to_the_condition) {
  using T = typename TypeParam::T;
  constexpr int n = TypeParam::columns;
  // Nearer to parallel, two columns of a closed form are one
  const double steepest = n <= 3 ? 0.02 / eps<T> : 1e16;
  const std::uint64_t seed = stress::first_seed(), count = stress::effort(500, 100000);
  adversarial::cones<T, n, n> cones(seed);
  for (std::uint64_t k = 0, checked = 0; checked < count; ++k) {
    const auto [B, f] = cones.draw();
    const double condition = ::condition<T, n, n>(B);
    bool moderate = true;  // the closed form in space takes no others
    for (int j = 0; j < n; ++j) moderate &= ph::detail::is_moderate(B.col(j).squaredNorm());
    if (!moderate || !(condition <= steepest)) continue;
    ++checked;
    ph::half_space_start start;
    const auto cold = ph::project_onto_half_spaces(B, f, start);
    const auto warm = ph::project_onto_half_spaces(B, f, start);
    const auto truth = oracle::nearest_point(B, f, cold.active);
    for (const auto& p : {cold.point, warm.point}) {
      oracle::column off(p.data(), p.data() + n);
      for (std::size_t i = 0; i < off.size(); ++i) off[i] -= truth[i];
      const double error = static_cast<double>(oracle::norm(off)) / eps<T>;
      ASSERT_LE(error, n <= 3 ? 4 : (4 * n + 2) * (1 + condition))
          << "roundings; seed " << seed << ", problem " << k << ", condition " << condition << "\nB =\n"
          << B << "\nf = " << f.transpose();
    }
  }
}

template <class Scalar>
struct space_cone : ::testing::Test {
  using T = Scalar;
  using vec = ph::vector<T, 3>;
  using half_spaces = ph::matrix<T, 3, 3>;
  using projection = ph::half_space_projection<T, 3, 3>;
  static constexpr double eps = ::eps<T>;

  static vec direction(ph::testing::random_source& random) { return random.direction<T, 3>(); }

  // |p - exact| of a projection, for |f| = 1.
  static double error_of(const projection& answer, const half_spaces& B, const vec& f) {
    const auto truth = oracle::project<T, 3, 3>(B, f);
    oracle::column off(answer.point.data(), answer.point.data() + 3);
    for (std::size_t i = 0; i < 3; ++i) off[i] -= truth.point[i];
    return static_cast<double>(oracle::norm(off));
  }

  // Three columns about one line, a hair from one plane.
  static half_spaces flat(double condition, ph::testing::random_source& random) {
    const vec u = direction(random), v = direction(random), w = direction(random);
    const T first = static_cast<T>(1 / std::sqrt(condition)), second = static_cast<T>(1 / condition);
    half_spaces B;
    for (int j = 0; j < 3; ++j) {
      const T a = random.coin() ? T(1) : T(-1), b = random.uniform(T(-1), T(1)),
              c = random.uniform(T(-1), T(1));
      B.col(j) = a * u + b * first * v + c * second * w;
    }
    return B;
  }
};
using scalars = ::testing::Types<double, float>;
TYPED_TEST_SUITE(space_cone, scalars);

// The face or edge of the cycle before is the answer or is refused: flat cones and forces near edges
// included.
TYPED_TEST(space_cone, a_start_is_taken_where_it_is_right_alone) {
  ph::testing::random_source random(6);
  int right = 0, taken = 0;
  for (int k = 0; k < 400; ++k) {
    typename TestFixture::half_spaces B;
    if (k % 2 == 0) B = TestFixture::flat(random.positive(1.0, 0.05 / TestFixture::eps), random);
    else
      for (int j = 0; j < 3; ++j) B.col(j) = random.normal_vector<TypeParam, 3>();
    auto f = TestFixture::direction(random);
    if (k % 3 == 0) f = ph::project_onto_half_spaces(B, f).point.stableNormalized();
    SCOPED_TRACE(::testing::Message() << "seed 6, trial " << k << "\nB =\n"
                                      << B << "\nf = " << f.transpose());
    const auto own = ph::project_onto_half_spaces(B, f).active;
    for (unsigned start = 0; start < 16; ++start) {
      typename TestFixture::projection answer;
      const bool found = ph::detail::space_cone_start<TypeParam>(B, f).nearest(start, answer);
      if (found) {
        ASSERT_EQ(answer.active, start);
        ASSERT_LE(TestFixture::error_of(answer, B, f), 6 * TestFixture::eps) << "start " << start;
      }
      if (k % 2 == 1 && k % 3 != 0 && start == own && own != 0 && own != 7) {
        ++right;
        taken += found ? 1 : 0;
      }
    }
  }
  EXPECT_GT(taken, right - right / 20);  // the others lie near a boundary or on a narrow edge
}

// Where products agree in all but their last digits.
TYPED_TEST(space_cone, difference_of_products_loses_no_digit) {
  ph::testing::random_source random(5);
  for (int k = 0; k < 1000; ++k) {
    const auto a = random.uniform(TypeParam(0.5), TypeParam(1)),
               b = random.uniform(TypeParam(0.5), TypeParam(1));
    const TypeParam hair = TypeParam(1) + TypeParam(4 * TestFixture::eps) * TypeParam(k % 7);
    const TypeParam c = a * hair, d = b / hair;
    const oracle::real exact = oracle::real(a) * b - oracle::real(c) * d;
    const oracle::real off = abs(ph::difference_of_products(a, b, c, d) - exact);
    EXPECT_LE(static_cast<double>(off), 1.5 * TestFixture::eps * static_cast<double>(abs(exact)))
        << "seed 5, " << k;
  }
}

}  // namespace
