/// Dead time and time constant of a brake from a step of the current.
#pragma once

#include <passive_haptics/bench/torque_fit.hpp>

namespace passive_haptics {

/// Result of a step of the current.
struct step_response {
  estimate before;         ///< Torque before the step [N m].
  estimate change;         ///< Final change by the step [N m]; < 0 for a step down.
  estimate time_constant;  ///< T [s].
  estimate dead_time;      ///< t_d, from the command to the first effect [s].
  double deviation = 0;    ///< Samples from the formula [N m].
};

namespace detail {

// Index of the first sample after the only step
inline std::size_t step_of_current(std::span<const bench_sample> samples) {
  require_samples(samples, 20);
  require_turning(samples, 10);
  std::size_t step = 0;
  int steps = 0;
  for (std::size_t k = 1; k < samples.size(); ++k) {
    if (samples[k].current == samples[k - 1].current) continue;
    step = k;
    ++steps;
  }
  refuse_unless(steps == 1, "steps of the current", steps,
                "1: record the step up and the step down separately");
  return step;
}

}  // namespace detail

/// Least squares of
///
///     torque = before                                            until t_d after the step,
///     torque = before + change (1 - exp(-(t - t_step - t_d) / T))   from then on
///
/// for samples with one step of the current while the axis turns steadily; t_step is the time of the last
/// sample with the old current. The dead time includes delays of bus, power stage and sensor. Throws
/// std::invalid_argument for invalid samples, torques without noise, an axis that stands still, no single
/// step, a change within the noise or against the current, a record shorter than five time constants, or one
/// above max_time_constant.
inline step_response fit_step_response(std::span<const bench_sample> samples,
                                       sensor_noise noise = sensor_noise::present) {
  const std::size_t step = detail::step_of_current(samples);
  const auto mean = [&](std::size_t from, std::size_t to) {
    double sum = 0;
    for (std::size_t k = from; k < to; ++k) sum += samples[k].torque;
    return sum / static_cast<double>(to - from);
  };
  const std::size_t end = samples.size(), tail = step + (end - step) * 4 / 5;
  const double t_step = samples[step - 1].time, before = mean(0, step), change = mean(tail, end) - before;

  const auto residual = [t_step]<class S>(const bench_sample& s, const vector<S, 4>& p) -> S {
    using std::exp;
    const S since = s.time - t_step - p[3];
    if (!(p[2] > S(0))) return S(std::numeric_limits<double>::quiet_NaN());
    if (!(since > S(0))) return p[0] - s.torque;
    return p[0] + p[1] * (S(1) - exp(-since / p[2])) - s.torque;
  };
  // The formula has a kink at the dead time: use the best of several starts within the first sample
  const double late = samples[step].time - t_step;
  const auto from = [&](double share) {
    return vector<double, 4>(before, change, (1 - share) * late, share * late);
  };
  const auto best = detail::fit_torques<4>(
      "samples", samples, noise, {from(0.02), from(0.1), from(0.3), from(0.6), from(0.9)}, residual);

  constexpr double sure = 5;  // standard errors, at least the rounding
  const double error = std::max(best.deviation, detail::min_noise * detail::max_torque(samples)) /
                       std::sqrt(static_cast<double>(end - tail));
  detail::refuse_unless(std::abs(best.value[1]) > sure * error, "change of the torque [N m]", best.value[1],
                        "a step above the noise: step to a larger current");
  const bool rises = samples[step].current > samples[step - 1].current;
  detail::refuse_unless((best.value[1] > 0) == rises, "change of the torque [N m]", best.value[1],
                        std::string(rises ? "> 0 as the current rises" : "< 0 as the current falls")
                            .append(": change the sign of torque_per_unit of the bench"));
  const double recorded = samples.back().time - t_step, needed = best.value[3] + 5 * best.value[2];
  detail::refuse_unless(recorded >= needed, "record after the step [s]", recorded,
                        detail::indexed("at least t_d + 5 T = ", needed, ": record longer"));
  require_no_error(check_time_constant("time constant [s]", best.value[2]));
  return {best[0], best[1], best[2], best[3], best.deviation};
}

}  // namespace passive_haptics
