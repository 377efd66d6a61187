// Elements of arrays by signed numbers.
#include <passive_haptics/core/nth.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

namespace stranger {
struct number {};
// As good a match, by argument-dependent lookup
template <class Array>
int nth(Array&&, int) = delete;
}  // namespace stranger

namespace passive_haptics {
namespace {

constexpr std::array<int, 3> numbers{5, 6, 7};
constexpr int plain[]{8, 9};
static_assert(nth(numbers, 2) == 7 && nth(plain, std::int8_t{1}) == 9);
static_assert(nth(numbers, std::integral_constant<int, 1>()) == 6);
static_assert(nth(std::array{1, 2}, 1L) == 2);
static_assert(std::is_same_v<decltype(nth(numbers, 0)), const int&>);

TEST(nth, is_the_element_itself) {
  std::array<int, 2> array{1, 2};
  int plain_array[]{1, 2};
  std::vector<int> vector{1, 2};
  const std::span<int> span = vector;
  std::vector<bool> bits{false, false};
  EXPECT_EQ(&nth(array, 1), &array[1]);
  EXPECT_EQ(&nth(plain_array, 1), &plain_array[1]);
  EXPECT_EQ(&nth(vector, std::ptrdiff_t(1)), &vector[1]);
  EXPECT_EQ(&nth(span, 1), &vector[1]);
  nth(bits, 1) = true;
  EXPECT_TRUE(bits[1]);
}

TEST(nth, is_no_function_of_the_namespace_of_elements) {
  const std::array<stranger::number, 1> array{};
  EXPECT_EQ(&nth(array, 0), array.data());
}

}  // namespace
}  // namespace passive_haptics
