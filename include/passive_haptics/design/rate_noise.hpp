/// @file
/// The noise of a rate that is estimated from the counts of an encoder.
#pragma once

#include <cmath>

namespace passive_haptics {

/// Standard deviation of the low-passed difference of an encoder's positions at a constant rate
/// [unit/s]. resolution: one count c [unit]; averaging_time: T_a > 0, twice the low-pass's time constant [s].
///
/// A rate w makes a count each c / |w|, and each count a pulse of area c that decays with T_a / 2. The mean
/// square of this train is that of a geometric series, so that the variance is
///
///     sigma^2 = |w| c / T_a coth(c / (|w| T_a)) - w^2.
///
/// While pulses stand apart, coth is 1 (Campbell's theorem, see wall_limits::drift). The noise grows with
/// the rate, up to c / (sqrt(3) T_a), that of positions that are each off by an even part of a count. 0 at
/// rest and for an ideal encoder, NaN where an argument is NaN. For a period that is short beside T_a.
inline double rate_noise(double rate, double resolution, double averaging_time) {
  const double w = std::abs(rate), most = resolution / averaging_time;
  const double x = w / most;                             // |w| in counts for each T_a
  if (resolution == 0 || w == 0) return w * resolution;  // NaN if one is NaN
  // coth(1 / x) = 1 + 2 / (e^(2 / x) - 1); for many counts x coth(1 / x) - x^2 is 1/3 - 1 / (45 x^2) + ...
  constexpr double many = 100;
  const double square = x > many ? 1.0 / 3 - 1 / (45 * x * x) : x + 2 * x / std::expm1(2 / x) - x * x;
  return most * std::sqrt(square);
}

}  // namespace passive_haptics
