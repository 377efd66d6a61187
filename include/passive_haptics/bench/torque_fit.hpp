/// Fits of torque formulas to noisy sensor torques.
#pragma once

#include <passive_haptics/bench/curve_fit.hpp>

#include <cmath>
#include <initializer_list>
#include <string>

namespace passive_haptics {

/// Expected noise of torques, the source of standard errors.
enum class sensor_noise {
  present,  ///< As of a sensor. Torques without noise are rejected, because the sensor hangs or is saturated.
  none,     ///< Computed torques, or a sensor coarser than its noise; a standard error of 0 is allowed.
};

namespace detail {

// Minimum relative deviation that counts as noise [1]; a 24-bit converter resolves 6e-8
inline constexpr double min_noise = 1e-9;

template <class Samples>
double max_torque(const Samples& samples) {
  double largest = 0;
  for (const auto& s : samples) largest = std::max(largest, std::abs(s.torque));
  return largest;
}

// The best of the fits from these starts. which: name of the samples in errors. Throws std::invalid_argument
// as fit_curve, or if torques that should have noise have none.
template <int N, class Samples, class Residual>
curve_fit<N> fit_torques(const std::string& which, const Samples& samples, sensor_noise noise,
                         std::initializer_list<vector<double, N>> starts, const Residual& residual) {
  const auto or_none = [](const char* expected) {
    return std::string(expected).append(
        ": read the sensor again for each sample, or pass sensor_noise::none for one without noise");
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
