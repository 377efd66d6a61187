/// @file
/// What a test bench records of one brake, and what is to be believed of it.
#pragma once

#include <passive_haptics/core/parameters.hpp>

#include <cmath>
#include <span>
#include <string>

namespace passive_haptics {

/// One reading of a bench, on which a motor or a hand turns a brake's axis. Of a sliding brake m and N.
struct bench_sample {
  double time = 0;      ///< [s]
  double current = 0;   ///< The last command to the brake before this reading [A].
  double position = 0;  ///< Of the axis, as its encoder reports it [rad].
  double torque = 0;    ///< Of the brake against a turn in the positive sense [N m].
};

/// A constant that was found.
struct estimate {
  double value = 0;  ///< In the unit of the constant.
  /// Of the value; infinite where the samples do not determine it, 0 only of samples without noise.
  double standard_error = 0;
};

/// The longest mean time between two samples of a test [s]: a longer one is milliseconds given as seconds.
inline constexpr double max_sample_period = 0.2;
/// The longest time constant of a brake [s]: a longer one is milliseconds given as seconds.
inline constexpr double max_time_constant = 5;

/// What is wrong with a time constant of this name [s], where it is longer than max_time_constant; empty
/// if nothing.
inline std::string check_time_constant(const char* name, double time_constant) {
  if (time_constant <= max_time_constant) return {};
  return detail::error_text(name, time_constant,
                            detail::indexed("at most ", max_time_constant,
                                            ": give the times of the samples in seconds, not milliseconds"));
}

/// Throws std::invalid_argument with the first number that cannot be: fewer samples than `least`, one that is
/// not finite, time that does not go on, or that goes on by more than max_sample_period from one to the
/// next.
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
                                        ": give times in seconds, not milliseconds, or record faster"));
}

/// Throws std::invalid_argument where the axis stands still or turns backwards in one of `parts` equal parts
/// of the samples: a brake at rest holds what it is pushed with, and does not show what it could.
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
