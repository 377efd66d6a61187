/// @file
/// The usual time between samples.
#pragma once

#include <algorithm>

namespace passive_haptics {

/// The mean of about the last 256 spacings of samples [s], which bursts of up to 32 samples change by 10 % at
/// most. A pause counts as 20 ms at most, or 16 times the mean if that is longer, so that samples at 1 kHz
/// are not taken for nearly simultaneous after a pause.
class sample_spacing {
 public:
  /// A spacing > 0 [s].
  void add(double spacing) noexcept {
    count_ = std::min(count_ + 1, 256.0);
    mean_ += (std::min(spacing, std::max(16 * mean_, max_burst)) - mean_) / count_;
  }
  /// Whether n spacings took so little time [s] that these may be times of arrival: about half of n times the
  /// mean. No rate is to be made of such samples alone.
  bool is_short(double time, int n = 1) const noexcept { return time < 0.55 * n * mean_; }

 private:
  static constexpr double max_burst = 0.020;  // [s]; an FTDI adapter waits for 16 ms by default

  double mean_ = 0, count_ = 0;
};

}  // namespace passive_haptics
