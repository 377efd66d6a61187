/// @file
/// A log that goes through the law of a device, line by line.
#pragma once

#include "simulation.hpp"

#include <array>
#include <string>
#include <vector>

namespace explorer {

/// The log of a device; see log_open().
class replayed_log {
 public:
  /// Throws example::log_error at the first line that is wrong.
  replayed_log(const device_parts& of, const std::string& text);
  /// Its lines.
  int count() const { return static_cast<int>(rows_.size()) / row_.size(); }
  /// The columns, filled with a line if there is one of this number.
  value_table& row(int line);
  /// Capacities as in the log, of those compared.
  double* agreement() { return agreement_.data(); }

 private:
  value_table row_;
  std::vector<double> rows_;
  std::array<double, 2> agreement_{};
};

}  // namespace explorer
