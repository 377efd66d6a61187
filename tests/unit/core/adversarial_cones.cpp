// slow, no sanitizers
// However ill-conditioned the cone: the nearest force is within 8 roundings of each half-space, and as exact
// as its condition allows; of two half-spaces in the plane and three in space exact to rounding. 1e7 problems
// with PASSIVE_HAPTICS_STRESS=full.
#include "adversarial_cones.hpp"
#include "../../stress/effort.hpp"
#include "cone_oracle.hpp"

#include <passive_haptics/core/linear/cone.hpp>

#include <gtest/gtest.h>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
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

using adversarial_sizes =
    ::testing::Types<size<double, 2, 2>, size<double, 2, 3>, size<double, 2, 4>, size<double, 3, 3>,
                     size<double, 3, 4>, size<double, 3, 7>, size<double, 4, 4>, size<double, 5, 5>,
                     size<double, 6, 6>, size<double, 7, 7>, size<float, 2, 2>, size<float, 2, 4>,
                     size<float, 3, 3>, size<float, 3, 7>, size<float, 4, 4>, size<float, 5, 5>,
                     size<float, 6, 6>, size<float, 7, 7>>;
TYPED_TEST_SUITE(adversarial_cone, adversarial_sizes);

TYPED_TEST(adversarial_cone, holds_the_nearest_force_to_8_roundings_from_any_start) {
  using T = typename TypeParam::T;
  constexpr int R = TypeParam::rows, C = TypeParam::columns;
  const std::uint64_t seed = stress::first_seed(), count = stress::effort(5000, 650000);
  adversarial::cones<T, R, C> cones(seed);
  ph::half_space_set of_another = 0;
  double worst = 0;
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
      worst = std::max(worst, outside);
      of_another = result.active;
    }
  }
  std::printf("worst violation %.2f eps of %llu problems\n", worst / eps<T>,
              static_cast<unsigned long long>(count));
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

using square_sizes = ::testing::Types<size<double, 2, 2>, size<double, 3, 3>, size<double, 4, 4>,
                                      size<double, 5, 5>, size<double, 6, 6>, size<double, 7, 7>,
                                      size<float, 2, 2>, size<float, 3, 3>, size<float, 4, 4>>;
TYPED_TEST_SUITE(adversarial_cone_in_50_digits, square_sizes);

TYPED_TEST(adversarial_cone_in_50_digits, is_exact_to_rounding_in_closed_form_else_to_the_condition) {
  using T = typename TypeParam::T;
  constexpr int n = TypeParam::columns;
  // Nearer to parallel, two columns of a closed form are one
  const double steepest = n <= 3 ? 0.02 / eps<T> : 1e16;
  const std::uint64_t seed = stress::first_seed(), count = stress::effort(1000, 100000);
  adversarial::cones<T, n, n> cones(seed);
  double worst = 0;
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
      worst = std::max(worst, n <= 3 ? error : error / (1 + condition));
    }
  }
  std::printf("worst error %.2g eps%s of %llu problems\n", worst, n <= 3 ? "" : " times the condition",
              static_cast<unsigned long long>(count));
}

}  // namespace
