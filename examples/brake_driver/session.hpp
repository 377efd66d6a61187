/// @file
/// From a configuration to brakes that hold: everything started in its order, the loop, and the summary.
#pragma once

#include <configuration/configuration.hpp>

#include <limits>

namespace example {

/// How a session is to run.
struct session_options {
  double seconds = std::numeric_limits<double>::infinity();  ///< When it ends by itself.
  bool live = true;                                          ///< Whether the terminal shows it.
  int live_port = 0;  ///< Local UDP port that gets the log as it comes (docs/guide/log.md); 0 for none.
};

/// Runs until a signal, the time or an exception ends it. 0, or 1 where the device is not there; else 3 where
/// a fault released the brakes, rearmed or not, or the device did not confirm 0 A, 4 where the log is not
/// whole, 7 both. Throws std::invalid_argument with what is wrong with the configuration.
int run_session(const configuration& c, const session_options& options);

}  // namespace example
