/// Samples of a test bench and their checks.
#pragma once

#include <passive_haptics/core/parameters.hpp>

#include <cmath>
#include <span>
#include <string>

namespace passive_haptics {

/// One reading of a bench while a motor or a hand turns the brake's axis; m and N for a sliding brake.
struct bench_sample {
  double time = 0;      ///< [s]
  double current = 0;   ///< Last command before this reading [A].
  double position = 0;  ///< Axis position by its encoder [rad].
  double torque = 0;    ///< Brake torque against a positive rotation [N m].
};

/// An identified constant.
struct estimate {
  double value = 0;  ///< In the unit of the constant.
  /// Infinite if the samples do not determine the value; 0 only for samples without noise.
  double standard_error = 0;
};

/// Maximum mean time between two samples of a test [s], which detects milliseconds.
inline constexpr double max_sample_period = 0.2;
/// Maximum time constant of a brake [s], which detects milliseconds.
inline constexpr double max_time_constant = 5;

/// Error text if the time constant [s] exceeds max_time_constant; empty otherwise.
inline std::string check_time_constant(const char* name, double time_constant) {
  if (time_constant <= max_time_constant) return {};
  return detail::error_text(name, time_constant,
                            detail::indexed("at most ", max_time_constant,
                                            ": pass the times of the samples in seconds, not milliseconds"));
}

/// Throws std::invalid_argument with the first invalid number: fewer samples than `least`, a value that is
/// not finite, times that do not increase, or a mean time between samples above max_sample_period.
inline void require_samples(std::span<const bench_sample> samples, std::size_t least) {
  detail::refuse_unless(samples.size() >= least, "samples", samples.size(),
                        detail::indexed("at least ", least, ": record longer or faster"));
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const bench_sample& s = samples[k];
    const auto named = [k](const char* member) {
      return detail::indexed("samples[", k, "].").append(member);
    };
    require_no_error(
        detail::first_error(check_value(named("time").c_str(), s.time, "s", range::finite),
                            check_value(named("current").c_str(), s.current, "A", range::not_negative),
                            check_value(named("position").c_str(), s.position, "rad", range::finite),
                            check_value(named("torque").c_str(), s.torque, "N m", range::finite)));
    detail::refuse_unless(k == 0 || s.time > samples[k - 1].time, named("time [s]"), s.time,
                          "more than that of the sample before");
  }
  if (samples.size() < 2) return;
  const double period =
      (samples.back().time - samples.front().time) / static_cast<double>(samples.size() - 1);
  detail::refuse_unless(period <= max_sample_period, "mean time between two samples [s]", period,
                        detail::indexed("at most ", max_sample_period,
                                        ": pass times in seconds, not milliseconds, or record faster"));
}

/// Throws std::invalid_argument if the axis stands still or moves backwards in one of `parts` equal parts of
/// the samples: a brake at rest only balances the applied torque.
inline void require_turning(std::span<const bench_sample> samples, std::size_t parts) {
  for (std::size_t i = 0; i < parts; ++i) {
    const bench_sample& first = samples[i * (samples.size() - 1) / parts];
    const bench_sample& last = samples[(i + 1) * (samples.size() - 1) / parts];
    detail::refuse_unless(
        last.position > first.position,
        detail::indexed("way [rad] from ", first.time, detail::indexed(" s to ", last.time, " s")),
        last.position - first.position,
        "> 0 throughout: turn the axis faster, or by a motor that is stronger than the brake");
  }
}

}  // namespace passive_haptics
