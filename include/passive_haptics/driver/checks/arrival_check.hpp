/// Detection of samples with the times of their arrival.
#pragma once

#include <passive_haptics/driver/checks/sample_spacing.hpp>

#include <cstdint>

namespace passive_haptics {

/// Detects sample times that look like times of arrival: a late sample is soon followed by the next. Rates
/// from such times are wrong; see device_clock.
class arrival_check {
 public:
  static constexpr std::uint64_t min_samples = 200;  ///< Minimum number for a result.
  static constexpr double max_share = 0.1;           ///< Of short spacings; a loop may be late at times.

  /// Adds the time of a good sample [s].
  void add(double time) noexcept {
    const double spacing = time - last_;
    last_ = time;
    if (!(spacing > 0) || samples_++ == 0) return;
    spacing_.add(spacing);
    if (spacing_.is_short(spacing)) ++short_;
  }

  /// Share of samples within about half the usual spacing after the previous one, 0 to 1.
  double share() const noexcept {
    return samples_ < 2 ? 0 : static_cast<double>(short_) / static_cast<double>(samples_ - 1);
  }
  /// True if the times look like times of arrival.
  bool found() const noexcept { return samples_ >= min_samples && share() > max_share; }

 private:
  sample_spacing spacing_;
  double last_ = 0;  // [s]
  std::uint64_t samples_ = 0, short_ = 0;
};

}  // namespace passive_haptics
