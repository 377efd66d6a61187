/// @file
/// Runs a logged motion through a control law, line by line.
#pragma once

#include <log/log_reader.hpp>

#include <passive_haptics/runtime/any_controller.hpp>

#include <cstddef>
#include <functional>
#include <ostream>

namespace example {

namespace ph = passive_haptics;

/// How a replay went [lines].
struct replay_summary {
  std::size_t lines = 0;
  std::size_t decided = 0;   ///< Those in which the law ran: not before homing, for example.
  std::size_t compared = 0;  ///< Of them, those whose capacities the log has as well,
  std::size_t same = 0;      ///< and has the same to the last digit.
};

/// Runs each line of a log through a controller and writes it with the decision to `out`, a log itself. A
/// line is written without a decision if a number is missing, or if the log has a status column that is empty
/// there. Where the law needs no force, a missing one is 0, as of a device without a force sensor. The
/// controller is reset where brake_driver reset its own: at each rearm, which the columns state and reason
/// show, unless the brakes were released in the same cycle again, for the same reason as before. Throws
/// log_error on the first malformed line. Memory does not grow with the log. `progress` hears the number of
/// lines done, every 65 536 of them.
replay_summary replay(log_reader& log, std::ostream& out, ph::runtime::any_controller& control,
                      const std::function<void(std::size_t)>& progress = {});

}  // namespace example
