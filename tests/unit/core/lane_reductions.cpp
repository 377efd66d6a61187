// Sums, products and the largest of lanes of any length: what is beyond the last number stays zero.
#include "../../tested_types.hpp"

#include <passive_haptics/core/linear/lane_products.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace ph = passive_haptics;

namespace {

template <class Scalar, int Length>
struct numbers {
  using T = Scalar;
  static constexpr int length = Length;
};

template <class Size>
struct lane_reductions : ::testing::Test {
  using number = typename Size::T;
  static constexpr int length = Size::length;
  static constexpr number rounding = number(4 * length) * std::numeric_limits<number>::epsilon();
  using numbers = std::array<number, static_cast<std::size_t>(length)>;
  using vector = ph::lanes<number, length>;

  static numbers draw(ph::testing::random_source& random) {
    numbers x;
    for (number& one : x) one = random.uniform(number(-1), number(1));
    return x;
  }
  static vector load(const numbers& x) { return vector::load(x.data()); }
  static numbers stored(const vector& x) {
    numbers y;
    x.store(y.data());
    return y;
  }
  static number dot(const numbers& a, const numbers& b) {
    number sum = number(0);
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
  }
};

// Shorter than a packet, one packet, several with and without a rest, and a number without packets
using lengths = tested_types<numbers<double, 3>, numbers<float, 4>, numbers<double, 8>, numbers<float, 7>,
                             numbers<long double, 2>>;
TYPED_TEST_SUITE(lane_reductions, lengths);

TYPED_TEST(lane_reductions, hold_their_numbers_and_zeros) {
  ph::testing::random_source random(1);
  const auto x = this->draw(random);
  const auto packed = this->load(x);
  EXPECT_EQ(this->stored(packed), x);
  if constexpr (packed.width > 1) {
    for (int i = TestFixture::length; i < packed.count * packed.width; ++i)
      EXPECT_EQ(packed.p[i / packed.width][i % packed.width], 0);
  }
}

TYPED_TEST(lane_reductions, subtract_multiply_and_sum) {
  using T = typename TestFixture::number;
  ph::testing::random_source random(2);
  for (int trial = 0; trial < 20; ++trial) {
    const auto x = this->draw(random), y = this->draw(random);
    EXPECT_LE(std::abs(dot(this->load(x), this->load(y)) - this->dot(x, y)), TestFixture::rounding);
    auto difference = this->load(x);
    difference -= T(0.5) * this->load(y);
    const auto opposite = this->stored(-difference);
    for (std::size_t i = 0; i < x.size(); ++i)
      EXPECT_LE(std::abs(opposite[i] - (y[i] / 2 - x[i])), TestFixture::rounding);
  }
}

TYPED_TEST(lane_reductions, sums_stand_in_order) {
  constexpr int N = TestFixture::length;
  using T = typename TestFixture::number;
  ph::testing::random_source random(3);
  std::array<typename TestFixture::numbers, static_cast<std::size_t>(N)> rows;
  for (auto& row : rows) row = this->draw(random);
  const auto x = this->draw(random);
  const auto product = this->stored(ph::horizontal_add<T, N>(
      [&](int j) { return products(this->load(rows[static_cast<std::size_t>(j)]), this->load(x)); }));
  for (std::size_t j = 0; j < rows.size(); ++j)
    EXPECT_LE(std::abs(product[j] - this->dot(rows[j], x)), TestFixture::rounding) << "sum " << j;
}

TYPED_TEST(lane_reductions, largest_is_found_wherever_it_stands) {
  using T = typename TestFixture::number;
  ph::testing::random_source random(4);
  for (int where = 0; where < TestFixture::length; ++where) {
    auto x = this->draw(random);
    for (T& one : x) one = one < 0 ? T(0) : one;
    x[static_cast<std::size_t>(where)] = T(1.5);
    const auto [value, index] = ph::detail::find_max(this->load(x));
    EXPECT_EQ(index, where);
    EXPECT_LE(std::abs(value - T(1.5)), 64 * std::numeric_limits<T>::epsilon());
  }
}

TYPED_TEST(lane_reductions, largest_value_passes_over_what_is_no_number) {
  using T = typename TestFixture::number;
  ph::testing::random_source random(7);
  for (int where = 0; where < TestFixture::length; ++where) {
    auto x = this->draw(random);
    for (T& one : x) one = std::abs(one);
    x[static_cast<std::size_t>(where)] = T(2);
    EXPECT_EQ(ph::detail::max_value(this->load(x)), T(2)) << "entry " << where;
    x[static_cast<std::size_t>((where + 1) % TestFixture::length)] = std::numeric_limits<T>::quiet_NaN();
    EXPECT_EQ(ph::detail::max_value(this->load(x)), T(2)) << "entry " << where;
  }
}

TYPED_TEST(lane_reductions, truths_are_the_bits_of_a_set) {
  constexpr int N = TestFixture::length;
  using truths = ph::lane_mask<typename TestFixture::number, N>;
  for (unsigned set = 0; set < 1u << N; ++set) {
    const truths of_set = truths::of(set);
    for (int i = 0; i < N; ++i) ASSERT_EQ(of_set[i], (set >> i & 1u) != 0) << set;
    EXPECT_EQ(bits(of_set), set);
    EXPECT_TRUE(of_set == truths::of(set));
    for (int i = 0; i < N; ++i) EXPECT_FALSE(of_set == truths::of(set ^ 1u << i)) << set << ", " << i;
  }
}

TYPED_TEST(lane_reductions, largest_of_zeros_is_zero) {
  EXPECT_EQ(ph::detail::find_max(typename TestFixture::vector{}).value, 0);
  EXPECT_EQ(ph::detail::max_value(typename TestFixture::vector{}), 0);
}

}  // namespace
