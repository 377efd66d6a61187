/// Checks for new, complete and timely samples.
#pragma once

#include <passive_haptics/driver/fault.hpp>
#include <passive_haptics/driver/port.hpp>

#include <cmath>
#include <cstdint>

namespace passive_haptics {

/// Checks the samples of one device in reading order; values are checked elsewhere.
template <int N>
class sample_check {
 public:
  /// late_after [s]: maximum difference of a sample's time, past or future.
  explicit sample_check(double late_after) : late_after_(late_after) {}

  /// Returns the fault of a sample read with this status at time `now` [s], or none if it is good.
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

  void reset() noexcept { started_ = false; }  ///< Forgets the sequence, for a device that was reopened.

 private:
  static constexpr std::int32_t max_gap = 1000;  // samples; a second at 1 kHz

  double late_after_;
  bool started_ = false;
  std::uint32_t last_ = 0;
};

}  // namespace passive_haptics
