// Least squares with priorities and bounds in closed form: small cases, by hand.
#include "../support.hpp"

#include <passive_haptics/core/linear/least_squares_by_priority.hpp>

#include <cmath>
#include <limits>

namespace {

template <class T>
struct least_squares_by_priority : ::testing::Test {
  static constexpr T infinity = std::numeric_limits<T>::infinity();
  using unknowns = ph::vector<T, 2>;
  using one_row = ph::least_squares_level<T, 1, 2>;

  static one_row row(T a_0, T a_1, T b) { return {ph::matrix<T, 1, 2>(a_0, a_1), ph::vector<T, 1>(b)}; }
  template <class... Levels>
  static unknowns solve(const unknowns& lower, const unknowns& upper, const Levels&... levels) {
    return ph::least_squares_by_priority(lower, upper, levels...,
                                         ph::least_squares_level{ph::identity_matrix<T, 2>()});
  }
};
TYPED_TEST_SUITE(least_squares_by_priority, scalars);

}  // namespace

TYPED_TEST(least_squares_by_priority, leave_to_later_levels_what_earlier_ones_do_not_see) {
  using suite = TestFixture;
  using values = typename suite::unknowns;
  const values most = values::Constant(suite::infinity);
  EXPECT_EQ(suite::solve(-most, most), values(0, 0));
  EXPECT_EQ(suite::solve(-most, most, suite::row(2, 0, 4)), values(2, 0));
  EXPECT_EQ(suite::solve(-most, most, suite::row(2, 0, 4), suite::row(1, 1, 5)), values(2, 3));
  EXPECT_EQ(suite::solve(-most, most, suite::row(1, 1, 4)), values(2, 2)) << "the shortest";
  EXPECT_EQ(suite::solve(-most, most, suite::row(1, 1, 4), suite::row(2, 2, 7)), values(2, 2)) << "repeated";
  EXPECT_EQ(suite::solve(-most, most, suite::row(0, 0, 4), suite::row(0, 1, 7)), values(0, 7))
      << "says nothing";
}

// More unknowns than are eliminated in closed form, and fewer rows before the last level than unknowns: one
// and two.
TYPED_TEST(least_squares_by_priority, hold_for_few_rows_and_many_unknowns) {
  using T = TypeParam;
  constexpr int N = 6;
  using six = ph::vector<T, N>;
  ph::matrix<T, 2, N> rows = ph::matrix<T, 2, N>::Zero();
  rows.row(0).setOnes();
  const auto expect = [&](const ph::vector<T, 2>& b, const six& right) {
    const six found =
        ph::least_squares_by_priority(six(six::Zero()), six(six::Ones()), ph::least_squares_level{rows, b},
                                      ph::least_squares_level{ph::identity_matrix<T, N>()});
    expect_near(found, right, 10);
  };
  expect({T(3), T(0)}, six::Constant(T(0.5)));
  rows(1, 0) = 1;
  six first = six::Constant(T(0.4));
  first[0] = 1;
  expect({T(3), T(5)}, first);
}

TYPED_TEST(least_squares_by_priority, stop_at_the_bounds_exactly) {
  using suite = TestFixture;
  using values = typename suite::unknowns;
  const values none = values::Zero(), one = values::Ones(), most = values::Constant(suite::infinity);
  EXPECT_EQ(suite::solve(none, one, suite::row(1, 1, 4)), values(1, 1));
  EXPECT_EQ(suite::solve(none, one, suite::row(1, -1, 4)), values(1, 0));
  EXPECT_EQ(suite::solve(none, one, suite::row(1, 2, 2), suite::row(0, 1, 9)), values(0, 1))
      << "along the first";
  EXPECT_EQ(suite::solve(none, most, suite::row(1, 0, -3), suite::row(0, 1, 3)), values(0, 3));
  EXPECT_EQ(suite::solve(one, one, suite::row(1, 2, 9)), values(1, 1)) << "no room";
  EXPECT_EQ(suite::solve(values(1, 0), values(1, 9), suite::row(1, 2, 9)), values(1, 4)) << "one is fixed";
}

// The best without bounds violates both; held at the first of them the second leads away again.
TYPED_TEST(least_squares_by_priority, release_a_bound_that_does_not_hold) {
  using T = TypeParam;
  using suite = TestFixture;
  using values = typename suite::unknowns;
  const ph::least_squares_level<T, 2, 2> level{ph::matrix_of<2, 2>(T(1), T(1), T(0), T(0.125)), {T(1), T(2)}};
  EXPECT_EQ(level.A * values(-15, 16), level.b);
  EXPECT_EQ(suite::solve(values(-4, 0), values(3, 3), level), values(-2, 3)) << "not at -4";
}

TYPED_TEST(least_squares_by_priority, take_a_row_of_rounding_for_none) {
  using T = TypeParam;
  using suite = TestFixture;
  using values = typename suite::unknowns;
  const values most = values::Constant(suite::infinity);
  const T rounding = std::numeric_limits<T>::epsilon();
  const values x = suite::solve(-most, most, suite::row(1, 1, 2), suite::row(1, 1 + rounding, 3));
  expect_near(x, values(1, 1), 2);
}

TYPED_TEST(least_squares_by_priority, hand_on_what_is_not_a_number) {
  using T = TypeParam;
  using suite = TestFixture;
  using values = typename suite::unknowns;
  const values most = values::Constant(suite::infinity);
  const T nan = std::numeric_limits<T>::quiet_NaN();
  EXPECT_FALSE(ph::all_finite(suite::solve(-most, most, suite::row(1, 0, nan))));
  EXPECT_FALSE(ph::all_finite(suite::solve(-most, most, suite::row(nan, 0, 1))));
  EXPECT_FALSE(ph::all_finite(suite::solve(-most, most, suite::row(0, 1, 1), suite::row(nan, 1, 1))));
}
