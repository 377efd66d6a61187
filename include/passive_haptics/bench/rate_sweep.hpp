/// Brake torque over rate: drag, Stribeck effect, eddy currents.
#pragma once

#include <passive_haptics/bench/torque_fit.hpp>

#include <vector>

namespace passive_haptics {

/// Mean of a window of samples.
struct rate_and_torque {
  double rate = 0;    ///< [rad/s]
  double torque = 0;  ///< [N m]
};

/// Means over windows of about `duration` [s] of samples at one current. The rate is wrong by up to one count
/// per duration: choose long windows for slow rates. Throws std::invalid_argument as require_samples, for a
/// varying current, or for fewer than 8 windows.
inline std::vector<rate_and_torque> mean_over_windows(std::span<const bench_sample> samples,
                                                      double duration) {
  require_no_error(check_value("duration", duration, "s", range::positive));
  require_samples(samples, 2);
  std::vector<rate_and_torque> all;
  for (std::size_t first = 0, k = 0; k < samples.size(); ++k) {
    detail::refuse_unless(samples[k].current == samples[0].current,
                          detail::indexed("samples[", k, "].current [A]"), samples[k].current,
                          "that of the first: record the sweep at one current");
    const double elapsed = samples[k].time - samples[first].time;
    if (elapsed < duration) continue;
    double sum = 0;
    for (std::size_t i = first; i < k; ++i) sum += samples[i].torque;
    all.push_back(
        {(samples[k].position - samples[first].position) / elapsed, sum / static_cast<double>(k - first)});
    first = k;
  }
  detail::refuse_unless(all.size() >= 8, "windows", all.size(),
                        "at least 8: record longer, or shorter windows");
  return all;
}

namespace detail {

// Validates the means and returns the maximum rate [rad/s]
inline double max_rate_of(std::span<const rate_and_torque> means) {
  double max_rate = 0;
  for (std::size_t k = 0; k < means.size(); ++k) {
    const auto named = [k](const char* member) { return indexed("means[", k, "].").append(member); };
    require_no_error(
        first_error(check_value(named("rate").c_str(), means[k].rate, "rad/s", range::finite),
                    check_value(named("torque").c_str(), means[k].torque, "N m", range::finite)));
    max_rate = std::max(max_rate, std::abs(means[k].rate));
  }
  refuse_unless(max_rate > 0, "fastest rate [rad/s]", max_rate, "> 0: turn the axis, slowly and fast");
  return max_rate;
}

inline double torque_against_turn(const rate_and_torque& s) { return s.rate < 0 ? -s.torque : s.torque; }

// The best of the fits from these starts. The formula for w > 0 holds against the rotation at any w
template <int N, class Formula>
curve_fit<N> fit_against_rate(std::span<const rate_and_torque> means, sensor_noise noise,
                              std::initializer_list<vector<double, N>> starts, const Formula& formula) {
  const auto fit = fit_torques<N>("means", means, noise, starts,
                                  [&]<class S>(const rate_and_torque& s, const vector<S, N>& p) -> S {
                                    return formula(std::abs(s.rate), p) - torque_against_turn(s);
                                  });
  double sum = 0;
  for (const auto& s : means) sum += torque_against_turn(s);
  constexpr double sure = 5;  // standard errors
  const auto count = static_cast<double>(means.size());
  refuse_unless(sum / count >= -sure * fit.deviation / std::sqrt(count), "mean torque against the turn [N m]",
                sum / count, ">= 0: change the sign of torque_per_unit of the bench");
  return fit;
}

}  // namespace detail

/// Coulomb and viscous friction.
struct viscous_friction {
  estimate strength;     ///< Coulomb friction [N m].
  estimate drag;         ///< Viscous drag [N m s].
  double deviation = 0;  ///< Of the means [N m].
};

/// Least squares of torque = strength + drag w. Throws std::invalid_argument for numbers that are not finite,
/// too few means, torques without noise, an axis that stands still, torques that drive the rotation.
inline viscous_friction fit_viscous_friction(std::span<const rate_and_torque> means,
                                             sensor_noise noise = sensor_noise::present) {
  detail::max_rate_of(means);
  const auto fit = detail::fit_against_rate<2>(
      means, noise, {vector<double, 2>(0, 0)},
      []<class S>(double w, const vector<S, 2>& p) -> S { return p[0] + p[1] * w; });
  return {fit[0], fit[1], fit.deviation};
}

/// Friction with a Stribeck effect.
struct stribeck_friction {
  estimate strength;       ///< In fast slip [N m].
  estimate static_ratio;   ///< Strength at rest relative to fast slip [1].
  estimate stribeck_rate;  ///< Rate at which 1/e of the difference remains [rad/s].
  estimate drag;           ///< Viscous drag [N m s].
  double deviation = 0;    ///< Of the means [N m].
};

/// Fit of strength (1 + (static_ratio - 1) exp(-(w / stribeck_rate)^2)) + drag w; as fit_viscous_friction.
inline stribeck_friction fit_stribeck_friction(std::span<const rate_and_torque> means,
                                               sensor_noise noise = sensor_noise::present) {
  const double fast = detail::max_rate_of(means),
               strength = fit_viscous_friction(means, noise).strength.value;
  const auto torque = []<class S>(double w, const vector<S, 4>& p) -> S {
    using std::exp;
    if (!(p[2] > S(0))) return S(std::numeric_limits<double>::quiet_NaN());
    const S ratio = w / p[2];
    return p[0] * (S(1) + (p[1] - S(1)) * exp(-ratio * ratio)) + p[3] * w;
  };
  const auto from = [&](double share) { return vector<double, 4>(strength, 1.2, share * fast, 0); };
  const auto best = detail::fit_against_rate<4>(
      means, noise, {from(0.003), from(0.01), from(0.03), from(0.1), from(0.3)}, torque);
  return {best[0], best[1], best[2], best[3], best.deviation};
}

/// Eddy-current torque and Coulomb friction, without viscous drag.
struct eddy_current_torque {
  estimate strength;       ///< Coulomb friction [N m].
  estimate drag;           ///< 2 peak_torque / critical_rate, at low rates [N m s].
  estimate critical_rate;  ///< Rate of the maximum torque [rad/s]; infinite if all rates are too low.
  estimate peak_torque;    ///< Maximum torque at this current [N m]; infinite with critical_rate.
  double deviation = 0;    ///< Of the means [N m].
};

/// Least squares of torque = strength + drag w / (1 + (w / critical_rate)^2). Throws as fit_viscous_friction.
inline eddy_current_torque fit_eddy_current_torque(std::span<const rate_and_torque> means,
                                                   sensor_noise noise = sensor_noise::present) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const double fast = detail::max_rate_of(means);
  // The formula is almost linear in 1 / critical_rate^2, also at 0
  const auto torque = []<class S>(double w, const vector<S, 3>& p) -> S {
    const S weakened = S(1) + p[2] * w * w;
    if (!(weakened > S(0))) return S(std::numeric_limits<double>::quiet_NaN());
    return p[0] + p[1] * w / weakened;
  };
  const auto from = [&](double share) { return vector<double, 3>(0, 0, share / fast * (share / fast)); };
  const auto fit = detail::fit_against_rate<3>(means, noise, {from(0.3), from(1), from(3), from(10)}, torque);
  eddy_current_torque found{fit[0], fit[1], {infinite, infinite}, {infinite, infinite}, fit.deviation};
  constexpr double sure = 4;  // standard errors from 0
  if (!(fit[2].value > sure * fit[2].standard_error)) return found;
  found.critical_rate = fit.of([](const auto& p) {
    using std::sqrt;
    return 1.0 / sqrt(p[2]);
  });
  found.peak_torque = fit.of([](const auto& p) {
    using std::sqrt;
    return p[1] / (2.0 * sqrt(p[2]));
  });
  return found;
}

}  // namespace passive_haptics
