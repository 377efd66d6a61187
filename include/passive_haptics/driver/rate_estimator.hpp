/// @file
/// Rates from encoders whose sign can be trusted: the first-order adaptive window.
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

/// How rates are estimated.
struct rate_estimator_parameters {
  double resolution = 1;  ///< One step of the position, in its unit: 1 count.
  /// Most periods that an estimate looks back. More: smaller dead band, longer lag of slow motions.
  int window = 16;

  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = rate_estimator_parameters;
    return member_table(member("resolution", &p::resolution, "counts", range::positive),
                        member("window", &p::window, "periods", range::at_least(1)));
  }
};

/// The slowest rate that a window can distinguish from rest, resolution / (window period): slower ones are
/// estimated as 0, and none is estimated between it and 0. The Karnopp dead band of a brake whose rate is
/// estimated so: rate_dead_band of brake_parameters, with the resolution in rad (or m). A steady rate of
/// twice as much is always seen. [unit/s]
inline double rate_dead_band(double resolution, int window, double period) noexcept {
  return resolution / (window * period);
}

/// Longest group delay at constant acceleration a [unit/s^2]: half of the window that still fits a parabola,
/// min(window T, sqrt(16 resolution / a + T^2)) / 2. [s]
inline double rate_lag(double resolution, int window, double period, double acceleration) noexcept {
  return 0.5 * std::min(window * period, std::sqrt(16 * resolution / acceleration + period * period));
}

/// Latest time after a start from rest or a reversal, at constant acceleration a [unit/s^2], at which a
/// sample has the right sign: when two steps have been made within the window,
///
///     2 sqrt(resolution / a) + 2 T                                    if that is within window T,
///     2 resolution / (a window T) + window T / 2 + 2 T     else. [s]
inline double rate_onset(double resolution, int window, double period, double acceleration) noexcept {
  const double two_steps = 2 * std::sqrt(resolution / acceleration), span = window * period;
  return 2 * period + (two_steps <= span ? two_steps : 2 * resolution / (acceleration * span) + 0.5 * span);
}

/// Rates of `Axes` encoders. Of each, the end-fit first-order adaptive window (Janabi-Sharifi, Hayward, Chen,
/// Discrete-time adaptive windowing for velocity estimation, IEEE Trans. Control Systems Technology 8 (6),
/// 2000): with real sample times,
///
///     rate = (y_k - y_(k-n)) / (t_k - t_(k-n)),
///
/// n the last of 1, 2, ... for which the line through both ends passes each sample between within one
/// resolution. A line through sample k passes sample i so if its slope is in an interval; the intersection of
/// these grows sample by sample, so the cost is O(window) and needs no fitting.
///
/// Sample k-n ends no window and limits none if it is nearer in time to sample k than about half of n usual
/// spacings (sample_spacing): times of arrival may be nearly the same. At constant rate, after 200 samples,
/// the estimate then is at most twice the rate, and a resolution over the window, if bursts have up to 32
/// samples and last up to 20 ms, or have up to eight samples. If bursts are longer than the window, some
/// estimates are 0. The times at which samples were taken (port_sample, device_clock) have no such error.
///
/// A rate with |y_k - y_(k-n)| <= resolution is exactly 0: its sign is not certain. Any other has the sign of
/// the mean rate over its window, also if the encoder jitters about an edge (by less than half a step) and
/// samples are missing. At constant rate the error is below resolution / (t_k - t_(k-n)). Lag: rate_lag,
/// rate_onset.
///
/// Give it positions in counts and scale the rates: differences of counts are exact. Capacity: most window.
template <int Axes, int Capacity = 16>
class rate_estimator {
  static_assert(Axes > 0 && Capacity > 0);

 public:
  /// Throws std::invalid_argument with the text of validate(p), or if the window is over Capacity.
  explicit rate_estimator(const rate_estimator_parameters& p = {}) : p_(require_valid(p)) {
    detail::refuse_unless(p.window <= Capacity, "window [periods]", p.window,
                          detail::indexed("at most the capacity, ", Capacity, ""));
  }

  /// Positions at this time [s]; the rates [unit/s]. A position that is NaN or infinite, or a time that is
  /// not after the one before it, changes nothing.
  const vector<double, Axes>& add(double time, const vector<double, Axes>& position) noexcept {
    for (int i = 0; i < Axes; ++i) {
      if (!std::isfinite(time) || !std::isfinite(position[i]) || !axis(i).is_after(time)) continue;
      axis(i).push({time, position[i]});
      estimate(i);
    }
    return rate_;
  }

  /// The latest rates [unit/s].
  const vector<double, Axes>& rate() const noexcept { return rate_; }
  /// Time that the latest estimate of an axis looked back [s]; 0 before there are two samples.
  double span(int i) const noexcept { return nth(axes_, i).span; }

  /// As new, after a pause: rates are 0 until there are two samples.
  void reset() noexcept {
    axes_ = {};
    rate_.setZero();
  }

 private:
  struct sample {
    double time = 0, position = 0;
  };
  // The last samples of one axis
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
  double reach_ = p_.resolution * (1 + 1e-9);  // whole counts meet the limit exactly, whatever rounds
  std::array<history, static_cast<std::size_t>(Axes)> axes_{};
  vector<double, Axes> rate_ = vector<double, Axes>::Zero();
};

}  // namespace passive_haptics
