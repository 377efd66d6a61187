// Sine and cosine of float against double: of every 65537th number, in a full run of all 2^32.
#include "effort.hpp"

#include <passive_haptics/core/scalar/sine_cosine.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace ph = passive_haptics;

namespace {

using word = std::uint32_t;

// Error in units in the last place of the exact value.
double ulps(float value, double exact) {
  using numbers = std::numeric_limits<float>;
  constexpr word exponent_bits = 0x7f800000;
  const word bits = ph::detail::bit_cast<word>(static_cast<float>(exact)) & exponent_bits;
  const float power = std::max(ph::detail::bit_cast<float>(bits), numbers::min());
  return std::abs(value - exact) / (double(numbers::epsilon()) * power);
}

TEST(float_sines, are_within_their_bound_for_every_number) {
  constexpr double most = 0.9;
  constexpr std::uint64_t numbers = std::uint64_t(1) << 32;
  const std::uint64_t step = stress::effort(65537, 1);
  double worst = 0;
  for (std::uint64_t bits = 0; bits < numbers; bits += step) {
    const auto x = ph::detail::bit_cast<float>(static_cast<word>(bits));
    const auto [s, c] = ph::sine_cosine(x);
    if (!std::isfinite(x)) {
      ASSERT_TRUE(std::isnan(s) && std::isnan(c)) << std::hex << bits;
      continue;
    }
    const double exact = x;
    const double sine = ulps(s, std::sin(exact)), cosine = ulps(c, std::cos(exact));
    worst = std::max({worst, sine, cosine});
    ASSERT_LE(std::max(sine, cosine), most) << std::hexfloat << x;
  }
  std::printf("worst error: %.3f units in the last place\n", worst);
}

}  // namespace
