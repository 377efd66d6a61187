/// @file
/// A counter's counts, past the point where it wraps.
#pragma once

#include <passive_haptics/core/validate.hpp>

#include <cmath>
#include <limits>
#include <string>
#include <string_view>

namespace passive_haptics {

/// What is wrong with the width of a counter; empty if nothing.
inline std::string check_counter_bits(std::string_view name, int bits) {
  const bool good = bits == 0 || (bits >= 8 && bits <= 48);
  return good ? "" : detail::complaint(name, bits, "the counter's width, 8 to 48, or 0 if it never wraps");
}

/// Counts of a counter that wraps at 2^bits, signed or not, as a position that does not: the first count as it is, each
/// further one at the nearest place to the one before it. So two readings may be up to 2^(bits - 1) counts apart: with 16 bits
/// and 8192 counts a turn, 4 turns. Exact to 2^53 counts.
class count_unwrapper {
 public:
  /// A counter of this width; 0 for none: counts are positions. Throws std::invalid_argument unless bits is 0 or 8 to 48.
  explicit count_unwrapper(int bits = 0) : period_(bits > 0 ? std::ldexp(1.0, bits) : 0.0) {
    require_no_complaint(check_counter_bits("counter_bits", bits));
  }

  /// Position [counts] of this count. One that is NaN or infinite gives NaN and is forgotten.
  double operator()(double count) noexcept {
    if (!std::isfinite(count)) return std::numeric_limits<double>::quiet_NaN();
    if (period_ > 0 && started_) wraps_ -= std::round((count - last_) / period_);
    last_ = count;
    started_ = true;
    return count + wraps_ * period_;
  }

  /// As new: the next count is the first.
  void restart() noexcept {
    started_ = false;
    wraps_ = 0;
  }

 private:
  double period_, last_ = 0, wraps_ = 0;
  bool started_ = false;
};

}  // namespace passive_haptics
