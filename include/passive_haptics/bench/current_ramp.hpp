/// Torque over current, hysteresis and residual torque, from a slow ramp of the current up and down.
#pragma once

#include <passive_haptics/bench/torque_fit.hpp>
#include <passive_haptics/core/nth.hpp>
#include <passive_haptics/driver/calibration/brake_curve.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace passive_haptics {

/// Delay of the torque after the current: T + t_d of fit_step_response, for a step up and a step down [s].
struct ramp_delay {
  double rising = 0;   ///< Rising current.
  double falling = 0;  ///< Falling current.
};

/// A sample on a branch, with the delayed current.
struct branch_sample {
  double current = 0;    ///< [A]
  double torque = 0;     ///< [N m]
  bool falling = false;  ///< On the falling branch.
};

/// Result of a ramp of the current.
struct current_ramp {
  static constexpr int points = 11;  ///< At 0, 1, ..., 10 tenths of the maximum current.
  using branch = std::array<estimate, static_cast<std::size_t>(points)>;  ///< One value at each point.

  double max_current = 0;              ///< [A]
  estimate residual_torque;            ///< Torque before the ramp, not energised before [N m].
  branch rising;                       ///< Torque at each point, current rising [N m].
  branch falling;                      ///< Torque at each point, current falling [N m].
  estimate hysteresis;                 ///< Maximum distance of the branches [N m].
  std::vector<branch_sample> samples;  ///< Both branches.

  /// Table for a brake_calibration: the rising branch, without points that are not significantly above the
  /// previous one or not below the last one. A negative residual torque becomes 0.
  brake_curve curve() const {
    brake_curve p;
    p.residual_torque = std::max(residual_torque.value, 0.0);
    p.current_limit = max_current;
    p.hysteresis = std::max(hysteresis.value, 0.0);
    p.table[0] = {0, p.residual_torque};
    p.points = 1;
    constexpr double sure = 3;  // standard errors
    for (std::size_t i = 1; i < rising.size(); ++i) {
      const double torque = rising[i].value, least = nth(p.table, p.points - 1).torque;
      const bool rises = torque > least + sure * rising[i].standard_error && torque < rising.back().value;
      if (rises || i + 1 == rising.size())
        nth(p.table, p.points++) = {max_current * static_cast<double>(i) / (points - 1), torque};
    }
    return p;
  }
};

/// Returns an error text with what to do, empty if there is none; curve() is then valid.
inline std::string validate(const current_ramp& ramp) {
  constexpr double sure = 3;  // standard errors
  const estimate &top = ramp.rising.back(), &residual = ramp.residual_torque,
                 &most = *std::max_element(
                     ramp.rising.begin(), ramp.rising.end(),
                     [](const estimate& a, const estimate& b) { return a.value < b.value; });
  const auto doubt = [&](double standard_error) {
    return std::max(sure * standard_error, detail::min_noise * std::abs(top.value));
  };
  if (!(ramp.max_current > 0))
    return detail::error_text("max_current [A]", ramp.max_current,
                              "> 0: record a ramp, and pass its fit_current_ramp");
  if (!(top.value > residual.value + doubt(top.standard_error)))
    return detail::error_text(
        "rising[10] [N m]", top.value,
        top.value < residual.value - doubt(top.standard_error)
            ? "more than residual_torque: change the sign of torque_per_unit of the bench"
            : "more than residual_torque: ramp up to a larger current");
  if (!(residual.value >= -doubt(residual.standard_error)))
    return detail::error_text("residual_torque [N m]", residual.value,
                              ">= 0: set torque_at_zero of the bench while no load acts");
  if (top.value < most.value - doubt(std::hypot(most.standard_error, top.standard_error)))
    return detail::error_text(
        "rising[10] [N m]", top.value,
        detail::indexed("no less than ", most.value,
                        ", the maximum, which was at a lower current: ramp up only as long as "
                        "the torque rises, and let the brake cool first"));
  const std::string error = validate(ramp.curve());
  return error.empty() ? error : std::string("curve().").append(error).append(": ramp more slowly");
}

namespace detail {

inline void require_ramp(const current_ramp& ramp) {
  const std::string error = validate(ramp);
  require_no_error(error.empty() ? error : std::string("ramp.").append(error));
}

// The parabola through the samples within this width of a current, evaluated there
inline estimate torque_near(std::span<const branch_sample> all, bool falling, double current, double width,
                            sensor_noise noise) {
  std::vector<branch_sample> close_by;
  for (const auto& s : all)
    if (s.falling == falling && std::abs(s.current - current) <= width) close_by.push_back(s);
  refuse_unless(close_by.size() >= 8, indexed("samples near ", current, " A"), close_by.size(),
                "at least 8: ramp more slowly, and up to the same current and down to 0");
  return fit_torques<3>(indexed("samples near ", current, " A"), close_by, noise,
                        {vector<double, 3>(0, 0, 0)},
                        [&]<class S>(const branch_sample& s, const vector<S, 3>& p) -> S {
                          const double x = (s.current - current) / width;
                          return p[0] + x * (p[1] + x * p[2]) - s.torque;
                        })[0];
}

// Indices at which the current begins to rise, is first and last at its maximum, and is 0 again
struct ramp_corners {
  std::size_t start = 0, top = 0, leave = 0, end = 0;
};

inline ramp_corners corners_of_ramp(std::span<const bench_sample> samples) {
  ramp_corners at;
  while (at.start + 1 < samples.size() && samples[at.start + 1].current == 0) ++at.start;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    if (samples[k].current > samples[at.top].current) at.top = k;
    if (samples[k].current == samples[at.top].current) at.leave = k;
  }
  at.end = at.leave;
  while (at.end + 1 < samples.size() && samples[at.end].current > 0) ++at.end;
  const std::size_t pause = samples[0].current == 0 ? at.start + 1 : 0;
  refuse_unless(samples[at.top].current > 0, "greatest current [A]", samples[at.top].current, "> 0: ramp up");
  refuse_unless(pause >= 8, "samples at 0 A before the ramp", pause, "at least 8: begin with a pause at 0 A");
  return at;
}

// The samples of both branches, each with the delayed current
inline std::vector<branch_sample> branches_of_ramp(std::span<const bench_sample> samples,
                                                   const ramp_corners& at, const ramp_delay& delay) {
  // A current is held for the period before its sample
  const double half_period =
      (samples.back().time - samples.front().time) / (2 * static_cast<double>(samples.size() - 1));
  std::vector<branch_sample> all;
  for (std::size_t k = at.start + 1, j = 0; k < samples.size(); ++k) {
    const double now = samples[k].time;
    const bool down = now > samples[at.leave].time + delay.falling;
    const double late = down ? delay.falling : delay.rising, then = now + half_period - late;
    while (j > 0 && samples[j].time > then) --j;
    while (j + 1 < samples.size() && samples[j + 1].time <= then) ++j;
    // Skips the transient of the lag after each corner of the ramp
    const auto after = [&](std::size_t corner) {
      return now > samples[corner].time && now < samples[corner].time + 6 * late;
    };
    if (j + 1 == samples.size() || after(at.start) || after(at.top) || after(at.leave) || after(at.end))
      continue;
    const double part = (then - samples[j].time) / (samples[j + 1].time - samples[j].time);
    all.push_back({std::lerp(samples[j].current, samples[j + 1].current, part), samples[k].torque, down});
  }
  return all;
}

}  // namespace detail

/// Evaluates a ramp of the current while the axis turns steadily: a pause at 0 A, a constant rate up to the
/// maximum, a pause there, and a constant rate down to 0. Each torque is assigned to the current one delay
/// earlier, so that a lag does not appear as hysteresis. Throws std::invalid_argument for invalid samples,
/// torques without noise, an axis that stands still, another form of ramp, or a wrong result.
inline current_ramp fit_current_ramp(std::span<const bench_sample> samples, const ramp_delay& delay = {},
                                     sensor_noise noise = sensor_noise::present) {
  require_samples(samples, 100);
  require_turning(samples, 20);
  require_no_error(detail::first_error(check_value("rising", delay.rising, "s", range::not_negative),
                                       check_value("falling", delay.falling, "s", range::not_negative)));
  const detail::ramp_corners at = detail::corners_of_ramp(samples);
  const double share =
      std::max(delay.rising, delay.falling) / (samples[at.top].time - samples[at.start].time);
  detail::refuse_unless(share < 0.02, "delay over the time of the ramp", share,
                        "less than 0.02: ramp more slowly");

  current_ramp found;
  found.max_current = samples[at.top].current;
  found.residual_torque = detail::fit_torques<1>(
      "samples before the ramp", samples.first(at.start + 1), noise, {vector<double, 1>::Zero()},
      []<class S>(const bench_sample& s, const vector<S, 1>& p) -> S { return p[0] - s.torque; })[0];
  found.samples = detail::branches_of_ramp(samples, at, delay);

  constexpr int last = current_ramp::points - 1;
  const double width = found.max_current / (2 * last);
  for (std::size_t i = 0; i < found.rising.size(); ++i) {
    const double current = found.max_current * static_cast<double>(i) / last;
    found.rising[i] =
        i == 0 ? found.residual_torque : detail::torque_near(found.samples, false, current, width, noise);
    found.falling[i] =
        i == last ? found.rising[i] : detail::torque_near(found.samples, true, current, width, noise);
    const double apart = found.falling[i].value - found.rising[i].value;
    if (i == 0 || apart > found.hysteresis.value)
      found.hysteresis = {apart, std::hypot(found.falling[i].standard_error, found.rising[i].standard_error)};
  }
  detail::require_ramp(found);
  return found;
}

}  // namespace passive_haptics
