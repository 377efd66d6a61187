// slow
// Derivatives of dual numbers against a central difference in 50 digits.
#include "../high_precision.hpp"

#include <passive_haptics/core/scalar/dual_number.hpp>

#include <gtest/gtest.h>

#include <random>

namespace ph = passive_haptics;
using real = high_precision::real;

namespace {

// Calls f as a mechanism's position does: by names found with the arguments.
template <class F>
void expect_derivative(F f, double low, double high) {
  std::mt19937_64 random(20040627);
  std::uniform_real_distribution<double> number(low, high);
  for (int k = 0; k < 50; ++k) {
    const double x = number(random);
    const auto y = f(ph::dual_number<double, 1>::variable(x, 0));
    const real value = f(real(x));
    const real slope = high_precision::derivative([&](real h) -> real { return f(real(x + h)); });
    const double size = std::abs(x) + std::abs(double(value)) + std::abs(double(slope));
    EXPECT_NEAR(y.value(), double(value), 1e-14 * size) << "x = " << x;
    EXPECT_NEAR(y.derivatives()[0], double(slope), 1e-14 * size) << "x = " << x;
  }
}

}  // namespace

TEST(dual_number, functions_have_their_derivatives) {
  using std::abs, std::acos, std::asin, std::atan, std::atan2, std::cbrt, std::cos, std::cosh, std::exp;
  using std::hypot, std::log, std::pow, std::sin, std::sinh, std::sqrt, std::tan, std::tanh;
  expect_derivative([](auto x) -> decltype(x) { return sin(x) * cos(x); }, -4, 4);
  expect_derivative([](auto x) -> decltype(x) { return tan(x); }, -1, 1);
  expect_derivative([](auto x) -> decltype(x) { return asin(x) + 2 * acos(x); }, -0.8, 0.8);
  expect_derivative([](auto x) -> decltype(x) { return atan(x); }, -4, 4);
  expect_derivative([](auto x) -> decltype(x) { return atan2(x + 1, 2 - x * x); }, -0.9, 0.9);
  expect_derivative([](auto x) -> decltype(x) { return hypot(x, 1 - x); }, -2, 2);
  expect_derivative([](auto x) -> decltype(x) { return sqrt(x) + cbrt(x); }, 0.5, 4);
  expect_derivative([](auto x) -> decltype(x) { return exp(x) / log(x); }, 1.5, 3);
  expect_derivative([](auto x) -> decltype(x) { return sinh(x) - cosh(x) * tanh(x); }, -2, 2);
  expect_derivative([](auto x) -> decltype(x) { return pow(x, 3) + pow(x, -1.5) + pow(x, x); }, 0.8, 2);
  expect_derivative([](auto x) -> decltype(x) { return abs(x) * x; }, -2, -0.1);
}

TEST(dual_number, arithmetic_with_constants_of_any_type) {
  expect_derivative([](auto x) -> decltype(x) { return 3 * x - x / 7 + 2 / x - 1 + (1 - x) * x; }, 0.5, 2);
  expect_derivative(
      [](auto x) -> decltype(x) {
        auto y = x;
        y += x * x, y -= 1, y *= x, y /= x + 2;
        return y > 100 ? y : -y;
      },
      0.5, 2);
}

TEST(dual_number, is_what_a_choice_between_it_and_a_constant_gives) {
  expect_derivative([](auto x) -> decltype(x) { return x > 0 ? x * x : 0.0; }, 0.5, 2);
  expect_derivative([](auto x) -> decltype(x) { return x > 0 ? 0 : x * x; }, -2, -0.5);
  const auto x = ph::dual_number<float, 1>::variable(2, 0);
  const auto larger = x > 1 ? x : 1.0f;
  EXPECT_EQ(larger.derivatives()[0], 1);
}

TEST(dual_number, mixes_with_vectors_of_constants) {
  using number = ph::dual_number<double, 2>;
  const ph::matrix<double, 2, 2> A{{1, 2}, {3, 4}};
  const ph::vector<number, 2> q(number::variable(0.3, 0), number::variable(-2, 1));
  const ph::vector<number, 2> x = 0.5 * (A * q);
  EXPECT_EQ(x[0].value(), 0.5 * (0.3 - 4));
  EXPECT_EQ(x[0].derivatives(), (ph::vector<double, 2>(0.5, 1)));
  EXPECT_EQ(x[1].derivatives(), (ph::vector<double, 2>(1.5, 2)));
  EXPECT_DOUBLE_EQ(q.norm().derivatives()[1], -2 / std::hypot(0.3, 2));
}
