/// Replay of a logged motion under a control law.
#pragma once

#include <log/log_reader.hpp>

#include <passive_haptics/runtime/any_controller.hpp>

#include <cstddef>
#include <functional>
#include <ostream>

namespace example {

namespace ph = passive_haptics;

/// Result of a replay [lines].
struct replay_summary {
  std::size_t lines = 0;
  std::size_t decided = 0;   ///< Lines in which the law ran, without homing, for example.
  std::size_t compared = 0;  ///< Those with capacities in the log.
  std::size_t same = 0;      ///< Those with equal capacities to the last digit.
};

/// Runs each line of a log through a controller and writes it with the decision to `out`, again as a log. A
/// line has no decision if a number is missing, or if its cell of a status column is empty. If the law needs
/// no force, a missing one is 0. The controller is reset at each rearm of brake_driver, according to the
/// columns state and reason, except if the brakes were released again in the same cycle for the same reason.
/// Throws log_error for the first malformed line. Memory does not grow with the log. `progress` is called
/// with the number of lines every 65 536 lines.
replay_summary replay(log_reader& log, std::ostream& out, ph::runtime::any_controller& control,
                      const std::function<void(std::size_t)>& progress = {});

}  // namespace example
