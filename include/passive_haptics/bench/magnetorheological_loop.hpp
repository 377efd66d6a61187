/// Identification of a magnetorheological_brake (plant/brakes) from a ramp and a step of the current.
#pragma once

#include <passive_haptics/bench/current_ramp.hpp>
#include <passive_haptics/bench/step_response.hpp>
#include <passive_haptics/plant/brakes/magnetorheological_brake.hpp>

namespace passive_haptics {

/// Constants of the hysteresis loop, relative to the maximum current of the ramp.
struct magnetorheological_loop {
  double max_current = 0;     ///< [A]
  estimate torque_limit;      ///< Calibrated curve, without the residual torque [N m].
  estimate saturation;        ///< k [1].
  estimate coercive_current;  ///< c [1].
  estimate residual_torque;   ///< [N m]
  double deviation = 0;       ///< Samples from the formula [N m].
};

namespace detail {

// p: torque_limit, k, c, residual_torque
template <class S, class M>
auto magnetorheological_torque(const vector<S, 4>& p, const M& m) {
  return p[3] + saturating_torque(p[0], p[1], m);
}

}  // namespace detail

/// Least squares of torque = residual_torque + torque_limit tanh(k m) / tanh(k) for a ramp, with the current
/// j relative to its maximum, m = max(j - c, 0) for rising and m = min(j + c, 1 - c) for falling current.
/// Throws as fit_current_ramp.
inline magnetorheological_loop fit_magnetorheological_loop(const current_ramp& ramp,
                                                           sensor_noise noise = sensor_noise::present) {
  detail::require_ramp(ramp);
  const double greatest = ramp.max_current, residual = ramp.residual_torque.value;
  const auto left_over = [greatest]<class S>(const branch_sample& s, const vector<S, 4>& p) -> S {
    if (!(p[1] > S(0))) return S(std::numeric_limits<double>::quiet_NaN());
    const double j = s.current / greatest;
    const S up = j - p[2], down = j + p[2], limit = S(1) - p[2];
    const S m = s.falling ? (down < limit ? down : limit) : (up > S(0) ? up : S(0));
    return detail::magnetorheological_torque(p, m) - s.torque;
  };
  const vector<double, 4> start(ramp.rising.back().value - residual, 1.0, 0.02, residual);
  const auto fit = detail::fit_torques<4>("samples of the ramp", ramp.samples, noise, {start}, left_over);
  return {greatest, fit[0], fit[1], fit[2], fit[3], fit.deviation};
}

/// Result of a step of the coil current.
struct magnetorheological_step {
  estimate time_constant;  ///< T of the coil [s].
  estimate dead_time;      ///< t_d [s].
  double deviation = 0;    ///< Samples from the formula [N m].
};

/// Least squares of T and t_d of the current j, given the loop: m = j - c for a step up from 0 A (not
/// energised before), m = min(j + c, J - c) for a step down from J to 0 A. Throws as fit_step_response.
inline magnetorheological_step fit_magnetorheological_step(std::span<const bench_sample> samples,
                                                           const magnetorheological_loop& loop,
                                                           sensor_noise noise = sensor_noise::present) {
  detail::refuse_unless(loop.max_current > 0, "loop.max_current [A]", loop.max_current,
                        "> 0: pass the fit_magnetorheological_loop of a ramp");
  const auto torque = fit_step_response(samples, noise);
  const std::size_t step = detail::step_of_current(samples);
  const bench_sample &last_before = samples[step - 1], &first_after = samples[step];
  const bool down = first_after.current < last_before.current;
  const double J = std::max(last_before.current, first_after.current) / loop.max_current;
  const vector<double, 4> constants(loop.torque_limit.value, loop.saturation.value,
                                    loop.coercive_current.value, loop.residual_torque.value);
  const double c = constants[2];
  const auto left_over = [&]<class S>(const bench_sample& s, const vector<S, 2>& p) -> S {
    using std::exp;
    if (!(p[0] > S(0))) return S(std::numeric_limits<double>::quiet_NaN());
    const S since = s.time - last_before.time - p[1];
    const S left = since > S(0) ? S(exp(-since / p[0])) : S(1);
    const S up = J * (S(1) - left) - c, fallen = J * left + c, limit = S(J - c);
    const S m = down ? (fallen < limit ? fallen : limit) : (up > S(0) ? up : S(0));
    return detail::magnetorheological_torque<double>(constants, m) - s.torque;
  };
  const vector<double, 2> start(torque.time_constant.value, torque.dead_time.value);
  const auto fit = detail::fit_torques<2>("samples", samples, noise, {start}, left_over);
  require_no_error(check_time_constant("time constant [s]", fit.value[0]));
  return {fit[0], fit[1], fit.deviation};
}

/// Result of the three records of such a brake.
struct magnetorheological_identification {
  magnetorheological_loop loop;     ///< Constants of the loop.
  magnetorheological_step rising;   ///< Lag and dead time of a rising current.
  magnetorheological_step falling;  ///< Lag and dead time of a falling current.
  current_ramp ramp;                ///< With those delays.
};

/// Identifies a brake from a step up (not energised before), a step down to 0 A and a ramp, by iteration over
/// lag, loop and ramp. Throws as fit_step_response and fit_current_ramp.
inline magnetorheological_identification fit_magnetorheological_brake(
    std::span<const bench_sample> up, std::span<const bench_sample> down, std::span<const bench_sample> ramp,
    sensor_noise noise = sensor_noise::present) {
  const auto late = [](const auto& step) { return step.time_constant.value + step.dead_time.value; };
  magnetorheological_identification found;
  ramp_delay delay{late(fit_step_response(up, noise)), late(fit_step_response(down, noise))};
  constexpr int rounds = 3;  // the third changes the loop by less than its standard errors
  for (int k = 0; k < rounds; ++k) {
    found.ramp = fit_current_ramp(ramp, delay, noise);
    found.loop = fit_magnetorheological_loop(found.ramp, noise);
    found.rising = fit_magnetorheological_step(up, found.loop, noise);
    found.falling = fit_magnetorheological_step(down, found.loop, noise);
    delay = {late(found.rising), late(found.falling)};
  }
  return found;
}

}  // namespace passive_haptics
