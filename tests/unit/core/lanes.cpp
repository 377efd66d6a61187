// Lanes: each operation is that of the single numbers, bit by bit; a choice takes either as it is, NaN and
// the sign of zero included.
#include "../../tested_types.hpp"

#include <passive_haptics/core/linear/lane_products.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ph = passive_haptics;

namespace {

template <class Scalar, int Count>
struct size {
  using T = Scalar;
  static constexpr int count = Count;
};

template <class Size>
struct lanes : ::testing::Test {
  using number = typename Size::T;
  static constexpr int count = Size::count;
  using vector = ph::vector<number, count>;

  // Common numbers and the special ones
  static vector draw(ph::testing::random_source& random) {
    using limits = std::numeric_limits<number>;
    const number special[] = {number(0),          -number(0),          limits::quiet_NaN(),
                              limits::infinity(), -limits::infinity(), limits::denorm_min()};
    vector x;
    for (int i = 0; i < count; ++i) {
      const int k = static_cast<int>(random.uniform(0.0, 12.0));
      x[i] = k < 6 ? special[k] : random.uniform(number(-1), number(1));
    }
    return x;
  }
  static void expect_same(number a, number b) {
    if (std::isnan(b)) EXPECT_TRUE(std::isnan(a));
    else EXPECT_TRUE(a == b && std::signbit(a) == std::signbit(b)) << a << " is not " << b;
  }
};

// One packet, more, with and without a rest, and a number without packets
using sizes = tested_types<size<double, 3>, size<double, 1>, size<double, 4>, size<float, 3>, size<float, 7>,
                           size<long double, 2>>;
TYPED_TEST_SUITE(lanes, sizes);

TYPED_TEST(lanes, compute_what_single_numbers_do) {
  using fixture = TestFixture;
  using T = typename fixture::number;
  using each = ph::lanes<T, fixture::count>;
  ph::testing::random_source random(1);
  for (int round = 0; round < 1000; ++round) {
    const typename fixture::vector x = this->draw(random), y = this->draw(random);
    const each a = x, b = y;
    for (int i = 0; i < fixture::count; ++i) {
      fixture::expect_same(a[i], x[i]);
      fixture::expect_same((a + b)[i], x[i] + y[i]);
      fixture::expect_same((a - b)[i], x[i] - y[i]);
      fixture::expect_same((a * b)[i], x[i] * y[i]);
      fixture::expect_same((a / b)[i], x[i] / y[i]);
      fixture::expect_same((-a)[i], -x[i]);
      fixture::expect_same(abs(a)[i], std::abs(x[i]));
      fixture::expect_same(copysign(a, b)[i], std::copysign(x[i], y[i]));
      fixture::expect_same(sgn(a)[i], ph::sgn(x[i]));
      fixture::expect_same(sqrt(a)[i], std::sqrt(x[i]));
      fixture::expect_same(min(a, b)[i], std::min(x[i], y[i]));
      fixture::expect_same(max(a, b)[i], std::max(x[i], y[i]));
      fixture::expect_same(select(a < b, a, b)[i], x[i] < y[i] ? x[i] : y[i]);
      fixture::expect_same(each(T(3))[i], T(3));
      EXPECT_EQ((a < b)[i], x[i] < y[i]);
      EXPECT_EQ((a <= b)[i], x[i] <= y[i]);
      EXPECT_EQ((a > b)[i], x[i] > y[i]);
      EXPECT_EQ((a >= b)[i], x[i] >= y[i]);
      EXPECT_EQ(((a < b) | (a > b))[i], x[i] < y[i] || x[i] > y[i]);
      EXPECT_EQ(((a <= b) & (a >= b))[i], x[i] == y[i]);
    }
    EXPECT_EQ(any(a < b), (x.array() < y.array()).any());
    for (int i = 0; i < 32; ++i)
      EXPECT_EQ(bits(a < b) >> i & 1u, i < fixture::count && x[i] < y[i] ? 1u : 0u);
    for (int i = 0; i < 32; ++i)
      EXPECT_EQ(bits(a <= b) >> i & 1u, i < fixture::count && x[i] <= y[i] ? 1u : 0u);
    const typename fixture::vector stored = a;
    for (int i = 0; i < fixture::count; ++i) fixture::expect_same(stored[i], x[i]);
  }
}

TYPED_TEST(lanes, reduce_their_numbers_alone) {
  using fixture = TestFixture;
  using T = typename fixture::number;
  using each = ph::lanes<T, fixture::count>;
  typename fixture::vector x;
  for (int i = 0; i < fixture::count; ++i) x[i] = T(i + 2);  // what is beyond the last, 0, must not count
  EXPECT_EQ(sum(each(x)), x.sum());
  EXPECT_EQ(min_value(each(x)), T(2));
  EXPECT_EQ(min_value(-each(x)), -T(fixture::count + 1));
  const ph::lanes<T, 2> a = ph::vector<T, 2>(T(1), T(2)), b = ph::vector<T, 2>(T(3), T(5));
  EXPECT_EQ((ph::vector<T, 2>(horizontal_add(a, b))), (ph::vector<T, 2>(T(3), T(8))));
  EXPECT_FALSE(any(each(x) <= T(1)));
}

TYPED_TEST(lanes, multiply_matrices) {
  using fixture = TestFixture;
  using T = typename fixture::number;
  constexpr int N = fixture::count;
  ph::testing::random_source random(2);
  ph::matrix<T, 3, N> A;
  ph::matrix<T, N, 2> B;
  for (int j = 0; j < N; ++j) {
    A.col(j) = random.template normal_vector<T, 3>();
    B.row(j) = random.template normal_vector<T, 2>();
  }
  const ph::vector<T, N> x = random.template normal_vector<T, N>();
  const ph::vector<T, 3> y = random.template normal_vector<T, 3>();
  const T rounding = T(8 * N) * std::numeric_limits<T>::epsilon();
  EXPECT_TRUE(ph::times(A, x).isApprox(A * x, rounding));
  EXPECT_TRUE(ph::transposed_times(A, y).isApprox(A.transpose() * y, rounding));
  EXPECT_TRUE(ph::times(A, B).isApprox(A * B, rounding));
}

template <class T>
class pairs : public ::testing::Test {};
using all_scalars = tested_types<double, float, long double>;
TYPED_TEST_SUITE(pairs, all_scalars);

TYPED_TEST(pairs, are_swapped_and_told_apart) {
  using T = TypeParam;
  using V = ph::vector<T, 2>;
  const ph::lanes<T, 2> x = V(1, 2);
  EXPECT_EQ(V(swapped(x)), V(2, 1));
  for (const bool a : {false, true}) {
    for (const bool b : {false, true}) {
      const auto truths = ph::lanes<T, 2>(V(a ? 1 : 0, b ? 1 : 0)) > T(0);
      EXPECT_EQ(swapped(truths)[0], b);
      EXPECT_EQ(swapped(truths)[1], a);
      EXPECT_EQ(first_only(truths)[0], a);
      EXPECT_EQ(first_only(truths)[1], b && !a);
      // A truth is all bits of its number
      const T most = std::numeric_limits<T>::lowest();
      EXPECT_EQ(V(select(first_only(truths), most, T(0))), V(a ? most : T(0), b && !a ? most : T(0)));
      EXPECT_EQ(V(select(first_only(truths), T(0), most)), V(a ? T(0) : most, b && !a ? T(0) : most));
      EXPECT_EQ(V(select(swapped(truths), most, T(0))), V(b ? most : T(0), a ? most : T(0)));
    }
  }
  EXPECT_EQ(ph::select(true, T(1), T(2)), T(1));
  EXPECT_EQ(ph::select(false, T(1), T(2)), T(2));
}

}  // namespace
