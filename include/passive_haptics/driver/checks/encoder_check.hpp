/// @file
/// Encoder counts past the wrap of their counter, and whether a device can have moved so.
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/driver/fault.hpp>
#include <passive_haptics/driver/port.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace passive_haptics {

/// What encoders of a device can do.
struct encoder_limits {
  /// Faster than this is a jump [counts/s]; by default 24 turns/s of 8192 counts. With it a counter that
  /// wraps allows pauses up to wrap_time().
  double max_rate = 2e5;
  /// An encoder that does not change while the others together turn so far and no brake holds is frozen
  /// [counts]; 0: never checked. A turn of 8192 counts by default; more where friction alone can hold an
  /// axis.
  double frozen_travel = 8192;
  /// How many encoders there are, the first of all channels; the others never move.
  int encoders = std::numeric_limits<int>::max();

  /// The table of core/parameters.hpp.
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

/// The time between two samples from which on a counter of this width may have wrapped unseen [s]:
///
///     (2^bits / 2 - 2) / max_rate,
///
/// 2 for a count of rounding at each end. After such a pause, two different motions lead to the same counts.
/// max_rate in counts/s. Infinite if bits is 0: the counter never wraps.
inline double wrap_time(int bits, double max_rate) noexcept {
  return bits > 0 ? (std::ldexp(0.5, bits) - 2) / max_rate : std::numeric_limits<double>::infinity();
}

/// Follows N encoders from sample to sample.
template <int N>
class encoder_check {
 public:
  using counts = std::array<double, static_cast<std::size_t>(N)>;  ///< [counts]

  /// Throws std::invalid_argument with the text of validate(limits).
  explicit encoder_check(const encoder_limits& limits) : limits_(require_valid(limits)) {}

  /// Counters of this width wrap; 0: they never do. Before the first sample.
  void set_counter_bits(int bits) noexcept {
    turn_ = bits > 0 ? std::ldexp(1.0, bits) : 0.0;
    wrap_time_ = passive_haptics::wrap_time(bits, limits_.max_rate);
  }
  /// wrap_time() of these counters [s].
  double wrap_time() const noexcept { return wrap_time_; }

  /// Takes a sample; `free` says that no brake holds. A fault: the sample was not taken, or an encoder froze,
  /// which stays so, as does a counter that may have wrapped unseen since the last sample taken.
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
    // Nobody saw where the device went between two samples, but a sample that jumped was seen
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

  /// Where the encoders are, on past every wrap; the first sample's own counts to begin with [counts].
  const counts& position() const noexcept { return position_; }

 private:
  // Of a counter without or with a sign; without a width, as far as a double distinguishes single counts
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
  double turn_ = 0;                                             // counts until the counter wraps
  double wrap_time_ = std::numeric_limits<double>::infinity();  // [s]
  bool started_ = false;
  bool jumped_ = false;  // the sample before this one
  double unseen_ = 0;    // [s]
  fault_record frozen_;
  port_sample<N> last_;
  counts position_{};
  counts others_travel_{};  // since this one changed, without a brake
};

}  // namespace passive_haptics
