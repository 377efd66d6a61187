/// Rates from encoders with reliable signs: the first-order adaptive window.
#pragma once

#include <passive_haptics/core/matrix.hpp>
#include <passive_haptics/core/nth.hpp>
#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/driver/checks/sample_spacing.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace passive_haptics {

/// Parameters of rate_estimator.
struct rate_estimator_parameters {
  double resolution = 1;  ///< Step of the position, in its unit: 1 count.
  /// Maximum number of periods of an estimate. More: smaller dead band, longer lag of slow motions.
  int window = 16;

  static constexpr auto members() {
    using p = rate_estimator_parameters;
    return member_table(member("resolution", &p::resolution, "counts", range::positive),
                        member("window", &p::window, "periods", range::at_least(1)));
  }
};

/// Minimum rate that a window distinguishes from rest [unit/s], resolution / (window period); the
/// rate_dead_band of brake_parameters. Slower rates are estimated as 0; twice the value is always detected.
inline double rate_dead_band(double resolution, int window, double period) noexcept {
  return resolution / (window * period);
}

/// Maximum group delay at constant acceleration a [unit/s^2]: half the window that still fits a parabola,
/// min(window T, sqrt(16 resolution / a + T^2)) / 2. [s]
inline double rate_lag(double resolution, int window, double period, double acceleration) noexcept {
  return 0.5 * std::min(window * period, std::sqrt(16 * resolution / acceleration + period * period));
}

/// Maximum time from a start or reversal, at constant acceleration a [unit/s^2], to the first sample with the
/// right sign, after two steps within the window [s]:
///
///     2 sqrt(resolution / a) + 2 T                          if that is within window T,
///     2 resolution / (a window T) + window T / 2 + 2 T      otherwise.
inline double rate_onset(double resolution, int window, double period, double acceleration) noexcept {
  const double two_steps = 2 * std::sqrt(resolution / acceleration), span = window * period;
  return 2 * period + (two_steps <= span ? two_steps : 2 * resolution / (acceleration * span) + 0.5 * span);
}

/// Rates of `Axes` encoders by the end-fit first-order adaptive window (Janabi-Sharifi, Hayward, Chen,
/// Discrete-time adaptive windowing for velocity estimation, IEEE Trans. Control Systems Technology 8 (6),
/// 2000) with actual sample times:
///
///     rate = (y_k - y_(k-n)) / (t_k - t_(k-n)),
///
/// where n is the last of 1, 2, ... for which the line through both ends passes each sample between within
/// one resolution. Cost O(window).
///
/// Samples nearer in time than about half of n usual spacings (sample_spacing) are skipped, since times of
/// arrival may nearly coincide. The estimate is then at most twice the rate plus a resolution over the
/// window, for bursts of up to 32 samples in 20 ms, or of eight samples.
///
/// A rate with |y_k - y_(k-n)| <= resolution is exactly 0, because its sign is uncertain. Any other has the
/// sign of the mean rate over its window, also with missing samples and jitter by less than half a step. At
/// constant rate the error is below resolution / (t_k - t_(k-n)). Lag: rate_lag, rate_onset. Use positions in
/// counts, which have exact differences. Capacity: maximum window.
template <int Axes, int Capacity = 16>
class rate_estimator {
  static_assert(Axes > 0 && Capacity > 0);

 public:
  /// Throws std::invalid_argument with the text of validate(p), or if the window exceeds Capacity.
  explicit rate_estimator(const rate_estimator_parameters& p = {}) : p_(require_valid(p)) {
    detail::refuse_unless(p.window <= Capacity, "window [periods]", p.window,
                          detail::indexed("at most the capacity, ", Capacity, ""));
  }

  /// Adds finite positions at an increasing time [s]; others are ignored. Returns the rates [unit/s].
  const vector<double, Axes>& add(double time, const vector<double, Axes>& position) noexcept {
    for (int i = 0; i < Axes; ++i) {
      if (!std::isfinite(time) || !std::isfinite(position[i]) || !axis(i).is_after(time)) continue;
      axis(i).push({time, position[i]});
      estimate(i);
    }
    return rate_;
  }

  const vector<double, Axes>& rate() const noexcept { return rate_; }  ///< The latest rates [unit/s].
  /// Time span of the latest estimate of an axis [s]; 0 before two samples.
  double span(int i) const noexcept { return nth(axes_, i).span; }

  /// Restarts after a pause; rates are 0 until two samples.
  void reset() noexcept {
    axes_ = {};
    rate_.setZero();
  }

 private:
  struct sample {
    double time = 0, position = 0;
  };
  struct history {
    std::array<sample, static_cast<std::size_t>(Capacity + 1)> ring{};
    int newest = Capacity, size = 0;
    double span = 0;
    sample_spacing spacing;

    const sample& back(int n) const noexcept {
      const int i = newest - n;
      return nth(ring, i < 0 ? i + Capacity + 1 : i);
    }
    bool is_after(double time) const noexcept { return size == 0 || time > back(0).time; }
    void push(const sample& s) noexcept {
      if (size > 0) spacing.add(s.time - back(0).time);
      newest = newest == Capacity ? 0 : newest + 1;
      nth(ring, newest) = s;
      size += size <= Capacity;
    }
  };

  history& axis(int i) noexcept { return nth(axes_, i); }

  void estimate(int i) noexcept {
    history& of = axis(i);
    const sample now = of.back(0);
    double least = -std::numeric_limits<double>::infinity(),
           steepest = -least;  // slopes that pass all samples
    double moved = 0, elapsed = 0;
    for (int n = 1; n < of.size && n <= p_.window; ++n) {
      const sample& then = of.back(n);
      const double dy = now.position - then.position, dt = now.time - then.time;
      if (of.spacing.is_short(dt, n)) continue;
      const double slope = dy / dt;
      if (slope < least || slope > steepest) break;
      moved = dy;
      elapsed = dt;
      least = std::max(least, (dy - reach_) / dt);
      steepest = std::min(steepest, (dy + reach_) / dt);
    }
    of.span = elapsed;
    rate_[i] = std::abs(moved) > p_.resolution ? moved / elapsed : 0.0;
  }

  rate_estimator_parameters p_;
  double reach_ = p_.resolution * (1 + 1e-9);  // whole counts meet the limit exactly
  std::array<history, static_cast<std::size_t>(Axes)> axes_{};
  vector<double, Axes> rate_ = vector<double, Axes>::Zero();
};

}  // namespace passive_haptics
