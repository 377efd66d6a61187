// Lanes: each operation is that of the single numbers, bit by bit; a choice takes either as it is, NaN and
// the sign of zero included. What is beyond the last number stays zero and counts in no sum.
#include "../../tested_types.hpp"

#include <passive_haptics/core/linear/lane_products.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
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
  using limits = std::numeric_limits<number>;
  static constexpr int count = Size::count;
  static constexpr number rounding = number(8 * count) * limits::epsilon();
  using vector = ph::vector<number, count>;
  using each = ph::lanes<number, count>;
  ph::testing::random_source random{1};

  vector numbers() { return random.between<number, count>(-vector::Ones(), vector::Ones()); }
  // Common numbers and the special ones
  vector any_numbers() {
    const number special[] = {number(0),          -number(0),          limits::quiet_NaN(),
                              limits::infinity(), -limits::infinity(), limits::denorm_min()};
    vector x = numbers();
    for (number& one : x)
      if (const int k = static_cast<int>(random.uniform(0.0, 12.0)); k < 6) one = special[k];
    return x;
  }
  static void expect_same(number a, number b) {
    if (std::isnan(b)) EXPECT_TRUE(std::isnan(a));
    else EXPECT_TRUE(a == b && std::signbit(a) == std::signbit(b)) << a << " is not " << b;
  }
};

// Packets with a rest, one or several, and a number without packets
using sizes = tested_types<size<double, 3>, size<float, 7>, size<long double, 2>>;
TYPED_TEST_SUITE(lanes, sizes);

TYPED_TEST(lanes, compute_what_single_numbers_do) {
  using fixture = TestFixture;
  using T = typename fixture::number;
  using each = typename fixture::each;
  for (int round = 0; round < 1000; ++round) {
    const typename fixture::vector x = this->any_numbers(), y = this->any_numbers();
    const each a = x, b = y;
    const auto below = bits(a < b), at_most = bits(a <= b);
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
      EXPECT_EQ(below >> i & 1u, x[i] < y[i] ? 1u : 0u);
      EXPECT_EQ(at_most >> i & 1u, x[i] <= y[i] ? 1u : 0u);
    }
    EXPECT_EQ(any(a < b), (x.array() < y.array()).any());
    EXPECT_EQ((below | at_most) >> fixture::count, 0u);
    const typename fixture::vector stored = a;
    for (int i = 0; i < fixture::count; ++i) fixture::expect_same(stored[i], x[i]);
  }
}

TYPED_TEST(lanes, reduce_their_numbers_and_nothing_else) {
  using fixture = TestFixture;
  using T = typename fixture::number;
  using each = typename fixture::each;
  typename fixture::vector x;
  for (int i = 0; i < fixture::count; ++i) x[i] = T(i + 2);  // what is beyond the last, 0, must not count
  EXPECT_EQ(sum(each(x)), x.sum());
  EXPECT_EQ(min_value(each(x)), T(2));
  EXPECT_EQ(min_value(-each(x)), -T(fixture::count + 1));
  EXPECT_FALSE(any(each(x) <= T(1)));
  const ph::lanes<T, 2> a = ph::vector<T, 2>(T(1), T(2)), b = ph::vector<T, 2>(T(3), T(5));
  EXPECT_EQ((ph::vector<T, 2>(horizontal_add(a, b))), (ph::vector<T, 2>(T(3), T(8))));
  const each packed = each::load(x.data());
  if constexpr (packed.width > 1) {
    for (int i = fixture::count; i < packed.count * packed.width; ++i)
      EXPECT_EQ(packed.p[i / packed.width][i % packed.width], 0);
  }
}

TYPED_TEST(lanes, multiply_vectors_and_matrices) {
  using fixture = TestFixture;
  using T = typename fixture::number;
  constexpr int N = fixture::count;
  const T rounding = fixture::rounding;
  ph::matrix<T, 3, N> A;
  ph::matrix<T, N, N> B;
  for (int i = 0; i < 3; ++i) A.row(i) = this->numbers();
  for (int i = 0; i < N; ++i) B.row(i) = this->numbers();
  const ph::vector<T, N> x = this->numbers(), y = this->numbers();
  const ph::vector<T, 3> z = A * y;
  EXPECT_TRUE(ph::times(A, x).isApprox(A * x, rounding));
  EXPECT_TRUE(ph::transposed_times(A, z).isApprox(A.transpose() * z, rounding));
  EXPECT_TRUE(ph::times(A, B).isApprox(A * B, rounding));
  EXPECT_LE(std::abs(dot(typename fixture::each(x), typename fixture::each(y)) - x.dot(y)), rounding);
  // Sums stand in order
  const auto sums = ph::horizontal_add<T, N>(
      [&](int j) { return products(fixture::each::load(&B(0, j)), typename fixture::each(x)); });
  EXPECT_TRUE((ph::vector<T, N>(sums).isApprox(B.transpose() * x, rounding)));
}

TYPED_TEST(lanes, have_a_largest_wherever_it_stands) {
  using fixture = TestFixture;
  using T = typename fixture::number;
  using each = typename fixture::each;
  for (int where = 0; where < fixture::count; ++where) {
    typename fixture::vector x = this->numbers().cwiseAbs();
    x[where] = T(1.5);
    const auto [value, index] = ph::detail::find_max(each(x));
    EXPECT_EQ(index, where);
    EXPECT_LE(std::abs(value - T(1.5)), 64 * fixture::limits::epsilon());
    EXPECT_EQ(ph::detail::max_value(each(x)), T(1.5)) << "entry " << where;
    x[(where + 1) % fixture::count] = fixture::limits::quiet_NaN();
    EXPECT_EQ(ph::detail::max_value(each(x)), T(1.5)) << "entry " << where;
  }
  EXPECT_EQ(ph::detail::find_max(each{}).value, 0);
  EXPECT_EQ(ph::detail::max_value(each{}), 0);
}

TYPED_TEST(lanes, have_truths_that_are_the_bits_of_a_set) {
  constexpr int N = TestFixture::count;
  using truths = ph::lane_mask<typename TestFixture::number, N>;
  for (unsigned set = 0; set < 1u << N; ++set) {
    const truths of_set = truths::of(set);
    for (int i = 0; i < N; ++i) ASSERT_EQ(of_set[i], (set >> i & 1u) != 0) << set;
    EXPECT_EQ(bits(of_set), set);
    EXPECT_TRUE(of_set == truths::of(set));
    for (int i = 0; i < N; ++i) EXPECT_FALSE(of_set == truths::of(set ^ 1u << i)) << set << ", " << i;
  }
}

template <class T>
struct pairs : ::testing::Test {};
using all_scalars = tested_types<double, float, long double>;
TYPED_TEST_SUITE(pairs, all_scalars);

TYPED_TEST(pairs, are_swapped_and_told_apart) {
  using T = TypeParam;
  using V = ph::vector<T, 2>;
  EXPECT_EQ(V(swapped(ph::lanes<T, 2>(V(1, 2)))), V(2, 1));
  const T most = std::numeric_limits<T>::lowest();  // a truth is all bits of its number
  for (const bool a : {false, true}) {
    for (const bool b : {false, true}) {
      const auto truths = ph::lanes<T, 2>(V(a ? 1 : 0, b ? 1 : 0)) > T(0);
      EXPECT_EQ(V(select(first_only(truths), most, T(0))), V(a ? most : T(0), b && !a ? most : T(0)));
      EXPECT_EQ(V(select(first_only(truths), T(0), most)), V(a ? T(0) : most, b && !a ? T(0) : most));
      EXPECT_EQ(V(select(swapped(truths), most, T(0))), V(b ? most : T(0), a ? most : T(0)));
    }
  }
  EXPECT_EQ(ph::select(true, T(1), T(2)), T(1));
  EXPECT_EQ(ph::select(false, T(1), T(2)), T(2));
}

}  // namespace
