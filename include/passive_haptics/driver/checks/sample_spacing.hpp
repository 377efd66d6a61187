/// The usual time between samples.
#pragma once

#include <algorithm>

namespace passive_haptics {

/// Mean of about the last 256 sample spacings [s]. Bursts of up to 32 samples change it by at most 10 %. A
/// pause counts as at most 20 ms, or 16 times the mean if that is longer.
class sample_spacing {
 public:
  /// Adds a spacing > 0 [s].
  void add(double spacing) noexcept {
    count_ = std::min(count_ + 1, 256.0);
    mean_ += (std::min(spacing, std::max(16 * mean_, max_burst)) - mean_) / count_;
  }
  /// True if n spacings took less than about half of n times the mean [s], so that they may be times of
  /// arrival. Rates must not be based on such samples.
  bool is_short(double time, int n = 1) const noexcept { return time < 0.55 * n * mean_; }

 private:
  static constexpr double max_burst = 0.020;  // [s]; the default of FTDI adapters is 16 ms

  double mean_ = 0, count_ = 0;
};

}  // namespace passive_haptics
