/// Encoder counts beyond counter wraps, checked for plausible motion.
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/driver/fault.hpp>
#include <passive_haptics/driver/port.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace passive_haptics {

/// Limits of a device's encoders.
struct encoder_limits {
  /// Higher rates count as a jump [counts/s]. Default: 24 turns/s of 8192 counts. Also limits pauses, see
  /// wrap_time().
  double max_rate = 2e5;
  /// Travel of the other encoders together after which an unchanged encoder counts as frozen, if no brake
  /// holds [counts]; 0: not checked. Default: one turn of 8192 counts; use more if friction can hold an axis.
  double frozen_travel = 8192;
  /// Number of encoders, the first of all channels; the others never move.
  int encoders = std::numeric_limits<int>::max();

  static constexpr auto members() {
    using p = encoder_limits;
    return member_table(member("max_rate", &p::max_rate, "counts/s", range::positive)
                            .suspicious_below(1)
                            .suspicious_above(1e10),
                        member("frozen_travel", &p::frozen_travel, "counts", range::not_negative)
                            .suspicious_below(1)
                            .suspicious_above(1e9));
  }
};

/// Minimum time between two samples after which a counter of this width may have wrapped undetected [s],
///
///     (2^bits / 2 - 2) / max_rate,
///
/// with 2 for rounding by a count at each end. max_rate in counts/s. Infinite if bits is 0 (no wrap).
inline double wrap_time(int bits, double max_rate) noexcept {
  return bits > 0 ? (std::ldexp(0.5, bits) - 2) / max_rate : std::numeric_limits<double>::infinity();
}

/// Follows N encoders over their samples.
template <int N>
class encoder_check {
 public:
  using counts = std::array<double, static_cast<std::size_t>(N)>;  ///< [counts]

  /// Throws std::invalid_argument with the text of validate(limits).
  explicit encoder_check(const encoder_limits& limits) : limits_(require_valid(limits)) {}

  /// Sets the width at which counters wrap; 0: never. Call it before the first sample.
  void set_counter_bits(int bits) noexcept {
    turn_ = bits > 0 ? std::ldexp(1.0, bits) : 0.0;
    wrap_time_ = passive_haptics::wrap_time(bits, limits_.max_rate);
  }
  double wrap_time() const noexcept { return wrap_time_; }  ///< wrap_time() of these counters [s].

  /// Processes a sample; `free`: no brake holds. Returns a fault if the sample was rejected, or permanently
  /// if an encoder froze or a counter may have wrapped undetected.
  fault_record operator()(const port_sample<N>& sample, bool free) noexcept {
    for (std::size_t i = 0; i < sample.value.size(); ++i)
      if (!in_range(sample.value[i]))
        return {fault::count_out_of_range, fault_source::encoders, static_cast<int>(i)};
    if (!started_) {
      start(sample);
      return {};
    }
    const double elapsed = std::max(0.0, sample.time - last_.time);
    if (!(elapsed < wrap_time_)) return {fault::counter_wrapped, fault_source::encoders};
    // After a rejected jump, only the time before the jump is unobserved
    if (!jumped_) unseen_ = elapsed;
    jumped_ = true;
    counts moved;
    const double furthest = limits_.max_rate * unseen_ + 2;  // a count of rounding at each end
    double travel = 0;
    for (std::size_t i = 0; i < moved.size(); ++i) {
      moved[i] = sample.value[i] - last_.value[i];
      if (turn_ > 0) moved[i] = std::remainder(moved[i], turn_);
      if (!(std::abs(moved[i]) <= furthest))
        return {fault::encoder_jump, fault_source::encoders, static_cast<int>(i)};
      travel += std::abs(moved[i]);
    }
    jumped_ = false;
    last_ = sample;
    for (std::size_t i = 0; i < moved.size(); ++i) {
      position_[i] += moved[i];
      if (moved[i] != 0) others_travel_[i] = 0;
      else if (free) others_travel_[i] += travel;
      if (limits_.frozen_travel > 0 && static_cast<int>(i) < limits_.encoders &&
          others_travel_[i] > limits_.frozen_travel)
        frozen_ = {fault::encoder_frozen, fault_source::encoders, static_cast<int>(i)};
    }
    return frozen_;
  }

  /// Encoder positions beyond wraps, starting with the first sample's counts [counts].
  const counts& position() const noexcept { return position_; }

 private:
  // For counters with or without sign; without a width, as far as a double is exact
  bool in_range(double count) const noexcept {
    constexpr double max_exact = 1 / std::numeric_limits<double>::epsilon();
    return turn_ > 0 ? count >= -turn_ / 2 && count < turn_ : std::abs(count) <= max_exact;
  }

  void start(const port_sample<N>& sample) noexcept {
    last_ = sample;
    position_ = sample.value;
    started_ = true;
  }

  encoder_limits limits_;
  double turn_ = 0;                                             // counts per wrap
  double wrap_time_ = std::numeric_limits<double>::infinity();  // [s]
  bool started_ = false;
  bool jumped_ = false;  // the previous sample
  double unseen_ = 0;    // [s]
  fault_record frozen_;
  port_sample<N> last_;
  counts position_{};
  counts others_travel_{};  // since this one changed, without a brake
};

}  // namespace passive_haptics
