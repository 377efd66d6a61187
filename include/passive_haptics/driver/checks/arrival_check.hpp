/// @file
/// Whether the times of samples look like those of their arrival.
#pragma once

#include <passive_haptics/driver/checks/sample_spacing.hpp>

#include <cstdint>

namespace passive_haptics {

/// A device takes its samples at equal times. If a port stamps them when they arrive, a late one is soon
/// followed by the next. A rate made of such times is wrong by the lateness: see device_clock.
class arrival_check {
 public:
  static constexpr std::uint64_t min_samples = 200;  ///< Fewer say nothing.
  static constexpr double max_share = 0.1;  ///< Of short spacings, as of a loop that is late at times.

  /// The time of a good sample [s].
  void add(double time) noexcept {
    const double spacing = time - last_;
    last_ = time;
    if (!(spacing > 0) || samples_++ == 0) return;
    spacing_.add(spacing);
    if (spacing_.is_short(spacing)) ++short_;
  }

  /// The share of samples that came less than about half of the usual spacing after the one before, 0 to 1.
  double share() const noexcept {
    return samples_ < 2 ? 0 : static_cast<double>(short_) / static_cast<double>(samples_ - 1);
  }
  /// Whether the times look like those of arrival.
  bool found() const noexcept { return samples_ >= min_samples && share() > max_share; }

 private:
  sample_spacing spacing_;
  double last_ = 0;  // [s]
  std::uint64_t samples_ = 0, short_ = 0;
};

}  // namespace passive_haptics
