/// Share of a device's rejected samples.
#pragma once

#include <passive_haptics/driver/fault.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace passive_haptics {

/// Counts arrived and rejected samples (damaged, invalid, out of range or a jump). A loose plug can spoil
/// every second sample, each of which `hold_over` would bridge.
class rejected_samples {
 public:
  static constexpr double max_share = 0.25;  ///< Share above which a device is not trusted.

  /// hold_over [s]: a tenth of the window of is_too_many().
  explicit rejected_samples(double hold_over) : part_(hold_over) {}

  /// Adds the result of a read at time `now` [s]; ignored if no new sample arrived.
  void add(fault found, double now) noexcept {
    if (found == fault::sample_missing || found == fault::sample_repeated) return;
    double passed = std::floor((now - begin_) / part_);
    if (!(std::abs(passed) < parts)) {  // first sample, a pause, or a jump of the clock
      begun_ = 0;
      begin_ = now - part_;
      passed = 1;
    }
    for (; passed > 0; --passed) {
      tally& oldest = recent_[begun_++ % parts];
      sum_.arrived -= oldest.arrived;
      sum_.rejected -= oldest.rejected;
      oldest = {};
      begin_ += part_;
    }
    for (tally* const t : {&all_, &sum_, &recent_[(begun_ - 1) % parts]}) {
      ++t->arrived;
      t->rejected += rejects_sample(found);
    }
  }

  /// True if at least a quarter of the samples within about the last ten `hold_over` were rejected; false
  /// until samples have arrived for that long.
  bool is_too_many() const noexcept {
    return begun_ >= parts &&
           static_cast<double>(sum_.rejected) >= max_share * static_cast<double>(sum_.arrived);
  }
  /// Share of rejected samples, 0 to 1.
  double share() const noexcept {
    return all_.arrived == 0 ? 0 : static_cast<double>(all_.rejected) / static_cast<double>(all_.arrived);
  }
  std::uint64_t arrived() const noexcept { return all_.arrived; }    ///< Number of arrived samples.
  std::uint64_t rejected() const noexcept { return all_.rejected; }  ///< Number of rejected samples.

 private:
  static constexpr std::size_t parts = 10;
  struct tally {
    std::uint64_t arrived = 0, rejected = 0;
  };

  double part_;                                              // [s]
  double begin_ = -std::numeric_limits<double>::infinity();  // start of the newest part [s]
  std::size_t begun_ = 0;                                    // parts since the first sample or a pause
  std::array<tally, parts> recent_{};
  tally sum_, all_;  // recent parts; all samples
};

}  // namespace passive_haptics
