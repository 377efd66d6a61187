/// Conversion of device time to the host's clock.
#pragma once

#include <algorithm>
#include <cstdint>

namespace passive_haptics {

/// Sampling times on the host's clock, for a device that sends its own time with each sample. The fastest
/// sample is assumed to have had no delay: host time = device time + minimum offset, which may grow by
/// `drift`. Delayed samples thus appear old. The remaining error is the shortest transfer time.
class device_clock {
 public:
  static constexpr double drift = 1e-3;  ///< Maximum rate error of a slow device clock; a quartz has 1e-4.

  /// Returns the time [s, host clock] of a sample with this device time [us, modulo 2^32] that was read at
  /// `now` [s, host clock]. Never later than `now`. A restarted device is followed from its first sample.
  double to_host(std::uint32_t device_time, double now) noexcept {
    // A step back is nearly 2^32 forward, which the minimum offset turns into a restart.
    const double step = started_ ? 1e-6 * static_cast<double>(device_time - last_) : 0;
    last_ = device_time;
    elapsed_ += step;
    offset_ = started_ ? std::min(offset_ + drift * step, now - elapsed_) : now;
    started_ = true;
    return std::min(offset_ + elapsed_, now);  // limits rounding
  }

 private:
  bool started_ = false;
  std::uint32_t last_ = 0;
  double elapsed_ = 0, offset_ = 0;  // [s]
};

}  // namespace passive_haptics
