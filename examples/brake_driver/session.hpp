/// A session: starts everything in order, runs the loop and prints a summary.
#pragma once

#include <configuration/configuration.hpp>

#include <limits>

namespace example {

struct session_options {
  double seconds = std::numeric_limits<double>::infinity();  ///< Duration.
  bool live = true;                                          ///< Displays it in the terminal.
  int live_port = 0;  ///< Local UDP port for the live log (docs/guide/log.md); 0 for none.
};

/// Runs until a signal, the time or an exception. Returns 0; 1 without the device; 3 if a fault released the
/// brakes, rearmed or not, or the device did not confirm 0 A; 4 if the log is incomplete; 7 for both. Throws
/// std::invalid_argument for a wrong configuration.
int run_session(const configuration& c, const session_options& options);

}  // namespace example
