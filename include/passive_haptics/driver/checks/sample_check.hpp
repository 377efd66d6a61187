/// @file
/// Whether a sample is a new, whole and timely one.
#pragma once

#include <passive_haptics/driver/fault.hpp>
#include <passive_haptics/driver/port.hpp>

#include <cmath>
#include <cstdint>

namespace passive_haptics {

/// Checks the samples of one device in the order in which they are read. What a channel's value may be is
/// left to others.
template <int N>
class sample_check {
 public:
  /// late_after [s]: how old, or how far ahead, a sample's time may be.
  explicit sample_check(double late_after) : late_after_(late_after) {}

  /// Of this sample, as read with this status at time `now` [s]: a fault, or none if it is good; then the
  /// next one is measured against it.
  fault_record operator()(port_status status, const port_sample<N>& sample, double now,
                          fault_source source) noexcept {
    const auto bad = [&](fault what, int channel = -1) { return fault_record{what, source, channel}; };
    if (status == port_status::failed) return bad(fault::device_lost);
    if (status == port_status::no_sample) return bad(fault::sample_missing);
    if (status != port_status::ok) return bad(fault::sample_damaged);
    // Modulo 2^32: half of all numbers are ahead of the last one
    const auto ahead = static_cast<std::int32_t>(sample.sequence - last_);
    if (started_ && (ahead > max_gap || ahead < -max_gap)) return bad(fault::device_restarted);
    if (started_ && ahead == 0) return bad(fault::sample_repeated);
    if (started_ && ahead < 0) return bad(fault::sample_out_of_order);
    if (!(std::abs(now - sample.time) <= late_after_)) return bad(fault::sample_late);
    for (int i = 0; i < N; ++i) {
      const auto channel = static_cast<std::size_t>(i);
      if (!sample.valid[channel]) return bad(fault::channel_invalid, i);
      if (!std::isfinite(sample.value[channel])) return bad(fault::value_not_finite, i);
    }
    started_ = true;
    last_ = sample.sequence;
    return {};
  }

  /// Forgets the sequence, for a device that was opened anew.
  void reset() noexcept { started_ = false; }

 private:
  static constexpr std::int32_t max_gap = 1000;  // samples; a second at 1 kHz is no gap any more

  double late_after_;
  bool started_ = false;
  std::uint32_t last_ = 0;
};

}  // namespace passive_haptics
