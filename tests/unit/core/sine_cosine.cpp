// Sine and cosine against 50 digits.
#include <passive_haptics/core/scalar/sine_cosine.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include <cmath>
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
  const auto [s, c] = ph::sine_cosine(x);
  EXPECT_LE(ulps(s, sin(exact(x))), 2.0) << "sine of " << x;
  EXPECT_LE(ulps(c, cos(exact(x))), 2.0) << "cosine of " << x;
}

TEST(sine_cosine, angles_of_every_size) {
  ph::testing::random_source random(11);
  for (int k = 0; k < 4000; ++k) {
    const double size = std::pow(10.0, random.uniform(-10.0, 5.0));
    check(random.uniform(-size, size));
    check(static_cast<float>(random.uniform(-size, size)));
    check(static_cast<long double>(random.uniform(-size, size)));
  }
}

TEST(sine_cosine, near_multiples_of_a_right_angle) {
  for (int k = -1000; k <= 1000; ++k) {
    const double right = k * std::numbers::pi / 2;
    for (const double x : {right, std::nextafter(right, 1e9), std::nextafter(right, -1e9)}) check(x);
  }
}

TEST(sine_cosine, beyond_its_own_range_it_is_that_of_the_c_library) {
  for (const double x : {1.1e5, -3e5, 1e22, std::nextafter(1e5, 2e5)}) {
    EXPECT_EQ(ph::sine_cosine(x).sine, std::sin(x));
    EXPECT_EQ(ph::sine_cosine(x).cosine, std::cos(x));
  }
  check(1e5);
}

// Two in one register are the same two; one too large takes both to the C library.
TEST(sine_cosine, of_two_angles_is_that_of_each) {
  ph::testing::random_source random(12);
  for (int k = 0; k < 2000; ++k) {
    const double x = random.uniform(-1e3, 1e3), y = random.uniform(-10.0, 10.0);
    const auto [first, second] = ph::sine_cosine(x, y);
    const auto [s, c] = ph::sine_cosine(x);
    EXPECT_EQ(first.sine, s);
    EXPECT_EQ(first.cosine, c);
    EXPECT_EQ(second.sine, ph::sine_cosine(y).sine);
    EXPECT_EQ(second.cosine, ph::sine_cosine(y).cosine);
  }
  for (const double large : {1.1e5, std::numeric_limits<double>::infinity()}) {
    for (const auto& pair : {ph::sine_cosine(large, 0.5)[1], ph::sine_cosine(0.5, large)[0]}) {
      EXPECT_EQ(pair.sine, std::sin(0.5));
      EXPECT_EQ(pair.cosine, std::cos(0.5));
    }
  }
}

TEST(sine_cosine, of_many_angles_is_that_of_each) {
  const ph::vector<float, 5> angles(ph::vector<float, 5>::LinSpaced(-2.f, 7.f));
  const auto all = ph::sine_cosine(angles);
  for (int i = 0; i < 5; ++i) {
    const auto [s, c] = ph::sine_cosine(angles[i]);
    EXPECT_EQ(all[static_cast<std::size_t>(i)].sine, s);
    EXPECT_EQ(all[static_cast<std::size_t>(i)].cosine, c);
  }
}

TEST(sine_cosine, special_values) {
  EXPECT_EQ(ph::sine_cosine(0.0).sine, 0.0);
  EXPECT_EQ(ph::sine_cosine(0.0).cosine, 1.0);
  const double denormal = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(ph::sine_cosine(denormal).sine, denormal);
  for (const double x : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_TRUE(std::isnan(ph::sine_cosine(x).sine));
    EXPECT_TRUE(std::isnan(ph::sine_cosine(-x).cosine));
  }
}

}  // namespace
