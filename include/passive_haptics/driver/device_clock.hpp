/// @file
/// A device's microseconds on the host's clock.
#pragma once

#include <algorithm>
#include <cstdint>

namespace passive_haptics {

/// The time at which a device took a sample, on the host's clock, for a port to a device that sends its own
/// time with each. Takes the sample that came fastest for one that took no time: host time = device time +
/// the least offset seen, which may grow by `drift` so that it follows a device whose clock is slow. A sample
/// that waited somewhere is then seen to be old. Samples are dated later than they were taken by the shortest
/// way to the host (the frame's time on the line).
class device_clock {
 public:
  static constexpr double drift =
      1e-3;  ///< How much slower than the host's the device's clock may be; a quartz is 1e-4.

  /// When a sample of this device time [us, modulo 2^32] was taken, which was read `now` [s, the host's
  /// clock]; the result, too. Never after `now`. A device that starts again is taken up with its first
  /// sample.
  double to_host(std::uint32_t device_time, double now) noexcept {
    // A step back is one of nearly 2^32 forward, of which the least offset makes a new beginning.
    const double step = started_ ? 1e-6 * static_cast<double>(device_time - last_) : 0;
    last_ = device_time;
    elapsed_ += step;
    offset_ = started_ ? std::min(offset_ + drift * step, now - elapsed_) : now;
    started_ = true;
    return std::min(offset_ + elapsed_, now);  // which rounding may pass
  }

 private:
  bool started_ = false;
  std::uint32_t last_ = 0;
  double elapsed_ = 0, offset_ = 0;  // [s]
};

}  // namespace passive_haptics
