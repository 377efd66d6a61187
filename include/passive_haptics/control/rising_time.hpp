/// Check that time increases from cycle to cycle.
#pragma once

#include <passive_haptics/core/status.hpp>

#include <limits>

namespace passive_haptics {

/// Time of the last cycle [s], for a law or an observer that uses time differences.
class rising_time {
 public:
  /// Stores the time [s] and returns ok if it is later than the last one, else status::time_not_rising.
  status next(double time) noexcept {
    const bool rises = time > last_;
    last_ = time;
    return rises ? status::ok : status::time_not_rising;
  }

 private:
  double last_ = -std::numeric_limits<double>::infinity();
};

}  // namespace passive_haptics
