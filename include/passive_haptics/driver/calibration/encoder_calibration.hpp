/// Conversion between encoder counts and axis positions.
#pragma once

#include <passive_haptics/core/finite.hpp>
#include <passive_haptics/core/nth.hpp>
#include <passive_haptics/driver/calibration/steady_mean.hpp>

#include <array>
#include <numbers>

namespace passive_haptics {

/// Encoders on the axes of a device (encoder_axes). counts_per_turn is negative if counts fall while the axis
/// moves in its positive sense, that of the mechanism's q or of w = T qd for a brake axis.
template <int Axes>
struct encoder_calibration_parameters {
  /// Signed edges per turn of the axis (4 per line); counts per metre for a slide.
  vector<double, Axes> counts_per_turn = vector<double, Axes>::Constant(8192);
  /// True for a sliding axis, in m instead of rad.
  std::array<bool, static_cast<std::size_t>(Axes)> slides{};
  vector<double, Axes> zero_count = vector<double, Axes>::Zero();  ///< Count at position 0; see homing.

  static constexpr auto members() {
    using p = encoder_calibration_parameters;
    return member_table(member("counts_per_turn", &p::counts_per_turn, "", range::finite)
                            .suspicious_below(1)
                            .suspicious_above(1e9),
                        member("slides", &p::slides),
                        member("zero_count", &p::zero_count, "", range::finite));
  }
  /// Requires counts_per_turn other than 0.
  std::string rules() const {
    for (int i = 0; i < Axes; ++i) {
      if (counts_per_turn[i] != 0) continue;
      return detail::error_text(detail::indexed("counts_per_turn[", i, "]"), counts_per_turn[i],
                                "a finite number, not 0; negative if counts fall in the positive sense");
    }
    return {};
  }
};

/// position = (count - zero_count) / counts_per_unit, in rad or m; counts are those of a safe_port.
template <int Axes>
class encoder_calibration {
 public:
  /// Throws std::invalid_argument with the text of validate(p).
  explicit encoder_calibration(const encoder_calibration_parameters<Axes>& p = {})
      : zero_count_(require_valid(p).zero_count), counts_per_unit_(p.counts_per_turn) {
    for (int i = 0; i < Axes; ++i)
      if (!nth(p.slides, i)) counts_per_unit_[i] /= 2 * std::numbers::pi;
  }

  /// Axis positions [rad or m].
  vector<double, Axes> position(const vector<double, Axes>& counts) const noexcept {
    return rate(counts - zero_count_);
  }
  /// Axis rates [rad/s or m/s] from counts/s.
  vector<double, Axes> rate(const vector<double, Axes>& counts) const noexcept {
    return counts.cwiseQuotient(counts_per_unit_);
  }
  /// Unrounded counts for axis positions [rad or m].
  vector<double, Axes> counts(const vector<double, Axes>& position) const noexcept {
    return zero_count_ + position.cwiseProduct(counts_per_unit_);
  }
  /// One count [rad or m].
  vector<double, Axes> resolution() const noexcept { return counts_per_unit_.cwiseAbs().cwiseInverse(); }

  const vector<double, Axes>& zero_count() const noexcept { return zero_count_; }  ///< Count at position 0.
  /// Sets the counts at position 0, as found by homing; ignores values that are not finite.
  void set_zero_count(const vector<double, Axes>& counts) noexcept {
    if (all_finite(counts)) zero_count_ = counts;
  }

 private:
  vector<double, Axes> zero_count_, counts_per_unit_;
};

/// Determines the zero counts while the handle is held still in a reference pose.
template <int Axes>
class homing {
 public:
  /// reference: axis positions in that pose [rad or m], of encoder_axes<M>::from_joints(q). Throws
  /// std::invalid_argument with the text of validate(p), or if the reference is not finite.
  homing(const encoder_calibration<Axes>& encoders, const vector<double, Axes>& reference,
         const steady_parameters& p = {})
      : from_zero_(encoders.counts(reference) - encoders.zero_count()), counts_(p) {
    require_no_error(check_value("reference", reference, "rad or m", range::finite));
  }

  /// Adds counts at a time [s]. Restarts on motion or gaps, as reported.
  steady_status add(double time, const vector<double, Axes>& counts) noexcept {
    return counts_.add(time, counts);
  }
  /// Counts at position 0, within half the tolerance and half a count; NaN until done.
  vector<double, Axes> zero_count() const noexcept { return counts_.mean() - from_zero_; }
  void reset() noexcept { counts_.reset(); }  ///< Restarts.

 private:
  vector<double, Axes> from_zero_;
  steady_mean<Axes> counts_;
};

}  // namespace passive_haptics
