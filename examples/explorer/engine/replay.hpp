/// @file
/// A log that goes through the law of a device, line by line.
#pragma once

#include "simulation.hpp"

#include <array>
#include <string>
#include <vector>

namespace explorer {

/// The log of a device.
class replayed_log {
 public:
  /// Throws example::log_error at the first line that is wrong.
  replayed_log(const device_parts& of, const std::string& text);
  /// The columns, as those of a simulation.
  const value_table& row() const { return row_; }
  /// A row for each line; NaN for what the log does not have.
  const std::vector<double>& rows() const { return rows_; }
  /// Lines with capacities equal to those of the law to the last digit, of those that have any.
  const std::array<double, 2>& agreement() const { return agreement_; }

 private:
  value_table row_;
  std::vector<double> rows_;
  std::array<double, 2> agreement_{};
};

}  // namespace explorer
