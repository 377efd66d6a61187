/// @file
/// From an encoder's counts to the position of its axis, and back.
#pragma once

#include <passive_haptics/core/finite.hpp>
#include <passive_haptics/core/nth.hpp>
#include <passive_haptics/driver/calibration/steady_mean.hpp>

#include <array>
#include <numbers>

namespace passive_haptics {

/// Encoders on the axes of a device (encoder_axes names them). Direction: counts_per_turn is negative where
/// counts fall while the axis turns in its positive sense, the one of the mechanism's q or, on a brake's
/// axis, of w = T qd.
template <int Axes>
struct encoder_calibration_parameters {
  /// All edges of a turn of the axis (4 for each line), signed; of a slide, counts per metre.
  vector<double, Axes> counts_per_turn = vector<double, Axes>::Constant(8192);
  /// True for an axis that slides: its position is in m, not rad.
  std::array<bool, static_cast<std::size_t>(Axes)> slides{};
  /// Count at position 0; homing finds it.
  vector<double, Axes> zero_count = vector<double, Axes>::Zero();

  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = encoder_calibration_parameters;
    return member_table(member("counts_per_turn", &p::counts_per_turn, "", range::finite)
                            .suspicious_below(1)
                            .suspicious_above(1e9),
                        member("slides", &p::slides),
                        member("zero_count", &p::zero_count, "", range::finite));
  }
  /// No axis has 0 counts.
  std::string rules() const {
    for (int i = 0; i < Axes; ++i) {
      if (counts_per_turn[i] != 0) continue;
      return detail::error_text(detail::indexed("counts_per_turn[", i, "]"), counts_per_turn[i],
                                "a finite number, not 0; negative if counts fall in the positive sense");
    }
    return {};
  }
};

/// position = (count - zero_count) / counts_per_unit of each axis; the unit is rad, of a slide m. Counts are
/// those of a safe_port, past the wraps of their counters.
template <int Axes>
class encoder_calibration {
 public:
  /// Throws std::invalid_argument with the text of validate(p).
  explicit encoder_calibration(const encoder_calibration_parameters<Axes>& p = {})
      : zero_count_(require_valid(p).zero_count), counts_per_unit_(p.counts_per_turn) {
    for (int i = 0; i < Axes; ++i)
      if (!nth(p.slides, i)) counts_per_unit_[i] /= 2 * std::numbers::pi;
  }

  /// Axis positions [rad or m] of counts.
  vector<double, Axes> position(const vector<double, Axes>& counts) const noexcept {
    return rate(counts - zero_count_);
  }
  /// Axis rates [rad/s or m/s] of rates in counts/s.
  vector<double, Axes> rate(const vector<double, Axes>& counts) const noexcept {
    return counts.cwiseQuotient(counts_per_unit_);
  }
  /// Counts, not rounded, of axis positions [rad or m].
  vector<double, Axes> counts(const vector<double, Axes>& position) const noexcept {
    return zero_count_ + position.cwiseProduct(counts_per_unit_);
  }
  /// One count [rad or m].
  vector<double, Axes> resolution() const noexcept { return counts_per_unit_.cwiseAbs().cwiseInverse(); }

  /// Count at position 0.
  const vector<double, Axes>& zero_count() const noexcept { return zero_count_; }
  /// From here on these are the counts at position 0, as from homing; others than finite ones change nothing.
  void set_zero_count(const vector<double, Axes>& counts) noexcept {
    if (all_finite(counts)) zero_count_ = counts;
  }

 private:
  vector<double, Axes> zero_count_, counts_per_unit_;
};

/// Finds the zero counts while the handle is held still in a reference pose.
template <int Axes>
class homing {
 public:
  /// reference: axis positions there [rad or m], encoder_axes<M>(mechanism).from_joints(q). The default takes
  /// 0.5 s within 3 counts. Throws std::invalid_argument with the text of validate(p), or if the reference is
  /// not finite.
  homing(const encoder_calibration<Axes>& encoders, const vector<double, Axes>& reference,
         const steady_parameters& p = {})
      : from_zero_(encoders.counts(reference) - encoders.zero_count()), counts_(p) {
    require_no_error(all_finite(reference) ? "" : "reference [rad or m], expected finite numbers");
  }

  /// Counts at this time [s]. Restarts on motion or gaps; the return value says so.
  steady_status add(double time, const vector<double, Axes>& counts) noexcept {
    return counts_.add(time, counts);
  }
  /// Counts at position 0; NaN until it is done. Within half the tolerance and half a count.
  vector<double, Axes> zero_count() const noexcept { return counts_.mean() - from_zero_; }
  /// As new.
  void reset() noexcept { counts_.reset(); }

 private:
  vector<double, Axes> from_zero_;
  steady_mean<Axes> counts_;
};

}  // namespace passive_haptics
