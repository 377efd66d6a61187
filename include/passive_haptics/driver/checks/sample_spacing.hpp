/// @file
/// The usual time between samples.
#pragma once

#include <algorithm>

namespace passive_haptics {

/// The mean of about the last 16 spacings of samples [s]. A pause counts as eight times the mean at most:
/// then the mean rises by less than a half, and samples after the pause are not taken for nearly
/// simultaneous. Bursts of up to eight samples are found.
class sample_spacing {
 public:
  /// A spacing > 0 [s].
  void add(double spacing) noexcept {
    count_ = std::min(count_ + 1, 16.0);
    const double counted = count_ > 1 ? std::min(spacing, 8 * mean_) : spacing;
    mean_ += (counted - mean_) / count_;
  }
  /// Whether two samples with this spacing [s] are nearer in time than half of the mean: their times may be
  /// those of their arrival, and no rate is to be made of the two alone.
  bool is_short(double spacing) const noexcept { return spacing < 0.5 * mean_; }

 private:
  double mean_ = 0, count_ = 0;
};

}  // namespace passive_haptics
