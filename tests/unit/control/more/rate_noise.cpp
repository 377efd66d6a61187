// The noise of estimated rates against 50 digits, its limits, and the encoder itself.
#include "../../high_precision.hpp"

#include <passive_haptics/design/rate_noise.hpp>
#include <passive_haptics/plant/encoder.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace {

namespace ph = passive_haptics;
using high_precision::real;

// The formula as its comment has it.
real exact_rate_noise(double rate, double resolution, double averaging_time) {
  const real w = rate, c = resolution, T = averaging_time;
  return sqrt(w * c / T / tanh(c / (w * T)) - w * w);
}

TEST(rate_noise, is_the_formula_in_50_digits) {
  constexpr double resolution = 7e-4, averaging_time = 0.0064;
  for (double counts = 1e-8; counts < 1e8; counts *= 1.37) {  // in an averaging time
    const double rate = counts * resolution / averaging_time;
    const double exact = static_cast<double>(exact_rate_noise(rate, resolution, averaging_time));
    EXPECT_NEAR(ph::rate_noise(rate, resolution, averaging_time), exact, 3e-11 * exact) << counts;
    EXPECT_EQ(ph::rate_noise(-rate, resolution, averaging_time),
              ph::rate_noise(rate, resolution, averaging_time));
  }
}

TEST(rate_noise, has_the_limits_of_single_pulses_and_of_many) {
  constexpr double c = 1e-3, T = 0.01;
  EXPECT_DOUBLE_EQ(ph::rate_noise(1e-9, c, T), std::sqrt(1e-9 * c / T - 1e-18)) << "Campbell's theorem";
  EXPECT_NEAR(ph::rate_noise(1e6, c, T), c / T / std::sqrt(3), 1e-10);
  EXPECT_DOUBLE_EQ(ph::rate_noise(std::numeric_limits<double>::max(), c, T), c / T / std::sqrt(3));
  double before = 0;
  for (double rate = 1e-300; rate < 1e300; rate *= 2) {
    const double now = ph::rate_noise(rate, c, T);
    EXPECT_GE(now, before * (1 - 1e-10)) << "it grows with the rate " << rate;
    before = now;
  }
}

TEST(rate_noise, is_0_at_rest_and_of_an_ideal_encoder) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(ph::rate_noise(0, 1e-3, 0.01), 0);
  EXPECT_EQ(ph::rate_noise(-0.0, 1e-3, 0.01), 0);
  EXPECT_EQ(ph::rate_noise(3, 0, 0.01), 0);
  EXPECT_DOUBLE_EQ(ph::rate_noise(std::numeric_limits<double>::infinity(), 1e-3, 0.01), 0.1 / std::sqrt(3));
  EXPECT_GT(ph::rate_noise(std::numeric_limits<double>::denorm_min(), 1, 1), 0);
  EXPECT_TRUE(std::isnan(ph::rate_noise(nan, 1e-3, 0.01)));
  EXPECT_TRUE(std::isnan(ph::rate_noise(1, nan, 0.01)));
  EXPECT_TRUE(std::isnan(ph::rate_noise(1, 1e-3, nan)));
}

TEST(rate_noise, is_that_of_an_encoder_which_is_read_often) {
  constexpr double period = 2e-5, corner = 50, c = 1e-3;
  const double T = 2 * ph::low_pass_time_constant(corner);
  for (const double counts : {0.1, 0.37, 1.0, 2.3, 7.1}) {  // in an averaging time
    const double rate = counts * c / T;
    ph::encoder<double, 1> read({.resolution = c, .rate_corner = corner}, period);
    using V = ph::vector<double, 1>;
    double mean = 0, squares = 0;
    const int settling = 5000, cycles = static_cast<int>(std::ceil(400 * c / rate / period));
    for (int k = 0; k < settling + cycles; ++k) {
      read.read(V::Constant(k * period * rate), V::Constant(rate));
      if (k < settling) continue;
      const double off = read.rate()[0] - rate;
      mean += off / cycles;
      squares += off * off / cycles;
    }
    const double expected = ph::rate_noise(rate, c, T);
    EXPECT_NEAR(std::sqrt(squares - mean * mean), expected, 0.01 * expected) << counts;
  }
}

}  // namespace
