// Sine and cosine against 50 digits.
#include <passive_haptics/core/scalar/sine_cosine.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <numbers>

namespace ph = passive_haptics;

namespace {

using exact = boost::multiprecision::cpp_bin_float_50;

// Error in units in the last place of the exact value.
template <class T>
double ulps(T value, const exact& truth) {
  int exponent = 0;
  std::frexp(static_cast<T>(truth), &exponent);
  const exact unit = ldexp(exact(1), exponent - std::numeric_limits<T>::digits);
  return static_cast<double>(abs(exact(value) - truth) / unit);
}

template <class T>
void check(T x) {
  constexpr double most = std::same_as<T, float> ? 0.9 : 2.0;
  const auto [s, c] = ph::sine_cosine(x);
  EXPECT_LE(ulps(s, sin(exact(x))), most) << "sine of " << x;
  EXPECT_LE(ulps(c, cos(exact(x))), most) << "cosine of " << x;
}

TEST(sine_cosine, angles_of_every_size) {
  ph::testing::random_source random(11);
  for (int k = 0; k < 1000; ++k) {
    const double size = std::pow(10.0, random.uniform(-10.0, 5.0));
    check(random.uniform(-size, size));
    check(static_cast<float>(random.uniform(-size, size)));
    check(static_cast<long double>(random.uniform(-size, size)));
  }
}

TEST(sine_cosine, near_multiples_of_a_right_angle) {
  for (int k = -200; k <= 200; ++k) {
    const double right = k * std::numbers::pi / 2;
    for (const double x : {right, std::nextafter(right, 1e9), std::nextafter(right, -1e9)}) check(x);
    const auto near = static_cast<float>(right);
    for (const float x : {near, std::nextafter(near, 1e9f), std::nextafter(near, -1e9f)}) check(x);
  }
}

// Few turns and many are reduced each in its own way.
TEST(sine_cosine, of_float_holds_for_every_size) {
  const float few = ph::detail::few_turns, largest = std::numeric_limits<float>::max();
  for (const float x : {few, std::nextafter(few, 1e9f), std::nextafter(few, 0.f), 1e5f, largest,
                        std::ldexp(1.f, 100), 16367173.f * std::ldexp(1.f, 72)}) {
    check(x);
    check(-x);
  }
  ph::testing::random_source random(13);
  for (int k = 0; k < 1000; ++k) check(static_cast<float>(std::exp2(random.uniform(-149.0, 127.9))));
}

TEST(sine_cosine, beyond_its_own_range_it_is_that_of_the_c_library) {
  for (const double x : {1.1e5, -3e5, 1e22, std::nextafter(1e5, 2e5)}) {
    EXPECT_EQ(ph::sine_cosine(x).sine, std::sin(x));
    EXPECT_EQ(ph::sine_cosine(x).cosine, std::cos(x));
  }
  check(1e5);
}

// Two in one register are the same two; one too large takes both to the C library.
template <class T>
void expect_same_of_two(T x, T y) {
  const auto pairs = ph::sine_cosine(x, y);
  const T angles[] = {x, y};
  for (const std::size_t k : {0u, 1u}) {
    const auto [s, c] = ph::sine_cosine(angles[k]);
    EXPECT_EQ(pairs[k].sine, s) << x << ", " << y;
    EXPECT_EQ(pairs[k].cosine, c) << x << ", " << y;
  }
}

TEST(sine_cosine, of_several_angles_is_that_of_each) {
  ph::testing::random_source random(12);
  for (int k = 0; k < 2000; ++k) expect_same_of_two(random.uniform(-1e3, 1e3), random.uniform(-10.0, 10.0));
  for (const double large : {1.1e5, std::numeric_limits<double>::infinity()}) {
    for (const auto& pair : {ph::sine_cosine(large, 0.5)[1], ph::sine_cosine(0.5, large)[0]}) {
      EXPECT_EQ(pair.sine, std::sin(0.5));
      EXPECT_EQ(pair.cosine, std::cos(0.5));
    }
  }
  for (const float x : {0.5f, 1e4f, 3e38f})
    for (const float y : {-0.7f, -1e30f}) expect_same_of_two(x, y);
  const ph::vector<float, 5> angles(ph::vector<float, 5>::LinSpaced(-2.f, 7.f));
  const auto all = ph::sine_cosine(angles);
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(all[static_cast<std::size_t>(i)].sine, ph::sine_cosine(angles[i]).sine);
    EXPECT_EQ(all[static_cast<std::size_t>(i)].cosine, ph::sine_cosine(angles[i]).cosine);
  }
}

template <class T>
void check_special_values() {
  using numbers = std::numeric_limits<T>;
  EXPECT_EQ(ph::sine_cosine(T(0)).sine, T(0));
  EXPECT_EQ(ph::sine_cosine(T(0)).cosine, T(1));
  EXPECT_EQ(ph::sine_cosine(numbers::denorm_min()).sine, numbers::denorm_min());
  for (const T x : {numbers::quiet_NaN(), numbers::infinity()}) {
    EXPECT_TRUE(std::isnan(ph::sine_cosine(x).sine));
    EXPECT_TRUE(std::isnan(ph::sine_cosine(-x).cosine));
    EXPECT_TRUE(std::isnan(ph::sine_cosine(x, T(1))[0].sine));
  }
}

TEST(sine_cosine, special_values) {
  check_special_values<double>();
  check_special_values<float>();
}

}  // namespace
