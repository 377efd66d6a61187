// slow, no sanitizers
// The closed form in space against an oracle in 50 digits: its error does not grow with the condition of the
// cone.
#include "cone_oracle.hpp"

#include <passive_haptics/core/linear/active_set.hpp>
#include <passive_haptics/core/linear/cone.hpp>
#include <passive_haptics/core/linear/space_cone.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ph = passive_haptics;

namespace {

template <class Scalar>
struct space_cone : ::testing::Test {
  using T = Scalar;
  using vec = ph::vector<T, 3>;
  using half_spaces = ph::matrix<T, 3, 3>;
  using projection = ph::half_space_projection<T, 3, 3>;
  static constexpr double eps = static_cast<double>(std::numeric_limits<T>::epsilon());

  static vec direction(ph::testing::random_source& random) { return random.direction<T, 3>(); }

  static bool closed_form(const half_spaces& B, const vec& f, projection& answer) {
    return ph::detail::space_cone<T>(B, f).nearest(answer);
  }

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
using scalars = ::testing::Types<double, float, long double>;
TYPED_TEST_SUITE(space_cone, scalars);

TYPED_TEST(space_cone, error_does_not_grow_with_the_condition) {
  ph::testing::random_source random(1);
  for (double condition = 1; condition <= 0.05 / TestFixture::eps; condition *= 10) {
    SCOPED_TRACE(::testing::Message() << "seed 1, condition " << condition);
    int refused = 0;
    for (int k = 0; k < 40; ++k) {
      const auto B = TestFixture::flat(condition, random);
      const auto f = TestFixture::direction(random);
      typename TestFixture::projection answer;
      if (TestFixture::closed_form(B, f, answer)) {
        EXPECT_LE(TestFixture::error_of(answer, B, f), 6 * TestFixture::eps)
            << "B =\n"
            << B << "\nf = " << f.transpose();
      } else {
        ++refused;
      }
    }
    EXPECT_LE(refused, condition * TestFixture::eps < 1e-3 ? 2 : 10) << "of 40";
  }
}

// The face or edge of the cycle before is the answer or is refused: flat cones and forces near edges
// included.
TYPED_TEST(space_cone, a_start_is_taken_where_it_is_right_alone) {
  ph::testing::random_source random(6);
  int right = 0, taken = 0;
  for (int k = 0; k < 2000; ++k) {
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

// Two brakes that pull along one line, or three in one plane: the singular poses.
TYPED_TEST(space_cone, parallel_columns_are_one_and_columns_in_a_plane_are_left_to_the_active_set) {
  ph::testing::random_source random(3);
  int refused = 0;
  for (int k = 0; k < 100; ++k) {
    typename TestFixture::half_spaces B;
    for (int j = 0; j < 3; ++j) B.col(j) = TestFixture::direction(random);
    auto parallel = B, plane = B;
    parallel.col(1) = random.uniform(TypeParam(-3), TypeParam(3)) * B.col(0);
    plane.col(2) = random.uniform(TypeParam(-1), TypeParam(1)) * B.col(0) +
                   random.uniform(TypeParam(-1), TypeParam(1)) * B.col(1);
    const auto f = TestFixture::direction(random);
    for (const auto& degenerate : {parallel, plane}) {
      SCOPED_TRACE(::testing::Message() << "seed 3, trial " << k << "\nB =\n" << degenerate);
      typename TestFixture::projection answer;
      refused += TestFixture::closed_form(degenerate, f, answer) ? 0 : 1;
      const auto p = ph::project_onto_half_spaces(degenerate, f).point;
      for (int j = 0; j < 3; ++j)
        EXPECT_LE(degenerate.col(j).dot(p), ph::rounding_tolerance<TypeParam>(3) * degenerate.col(j).norm());
    }
  }
  EXPECT_GT(refused, 0);
  EXPECT_LT(refused, 150);  // most have their answer on a face
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
