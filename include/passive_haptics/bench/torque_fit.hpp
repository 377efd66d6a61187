/// @file
/// The constants of a torque's formula from torques of a sensor, which have noise.
#pragma once

#include <passive_haptics/bench/curve_fit.hpp>

#include <cmath>
#include <initializer_list>
#include <string>

namespace passive_haptics {

/// Whether torques have the noise that the standard errors of their constants come from.
enum class sensor_noise {
  present,  ///< As of a sensor. Torques without any are refused: the sensor hangs, or is saturated.
  none,     ///< Computed ones, or of a sensor coarser than its noise: a standard error of 0 is no mistake.
};

namespace detail {

// The smallest deviation that is noise, for the largest torque [1]: a converter of 24 bits resolves 6e-8
inline constexpr double min_noise = 1e-9;

template <class Samples>
double max_torque(const Samples& samples) {
  double largest = 0;
  for (const auto& s : samples) largest = std::max(largest, std::abs(s.torque));
  return largest;
}

// The closest of the fits from these starts. which: of what samples, for the errors. Throws
// std::invalid_argument as fit_curve does, or where torques that should have noise have none.
template <int N, class Samples, class Residual>
curve_fit<N> fit_torques(const std::string& which, const Samples& samples, sensor_noise noise,
                         std::initializer_list<vector<double, N>> starts, const Residual& residual) {
  const auto or_none = [](const char* expected) {
    return std::string(expected).append(
        ": read the sensor anew for each sample, or give sensor_noise::none where there is none");
  };
  const auto differs = [&](const auto& s) { return s.torque != samples.front().torque; };
  if (noise == sensor_noise::present && std::ssize(samples) > N)
    refuse_unless(std::any_of(samples.begin(), samples.end(), differs),
                  indexed("torque of all ", which, " [N m]"), samples.front().torque,
                  or_none("readings that differ"));
  curve_fit<N> best;
  best.deviation = std::numeric_limits<double>::infinity();
  for (const auto& start : starts) {
    const auto fit = fit_curve<N>(samples, start, residual);
    if (fit.deviation < best.deviation) best = fit;
  }
  if (noise == sensor_noise::present)
    refuse_unless(best.deviation > min_noise * max_torque(samples), indexed("noise of the ", which, " [N m]"),
                  best.deviation, or_none("more than 1e-9 of the largest torque"));
  return best;
}

}  // namespace detail

}  // namespace passive_haptics
