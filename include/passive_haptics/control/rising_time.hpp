/// @file
/// A check of time for what uses time differences: each cycle must be later than the one before.
#pragma once

#include <passive_haptics/core/status.hpp>

#include <limits>

namespace passive_haptics {

/// The time of the last cycle [s], of a law or an observer that uses time differences.
class rising_time {
 public:
  /// ok, or status::time_not_rising unless this cycle's time [s] is later than that of the last one. The next
  /// cycle is compared with this one in any case, so a clock that is set back costs one cycle.
  status next(double time) noexcept {
    const bool rises = time > last_;
    last_ = time;
    return rises ? status::ok : status::time_not_rising;
  }

 private:
  double last_ = -std::numeric_limits<double>::infinity();
};

}  // namespace passive_haptics
