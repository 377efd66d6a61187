// One table of all runs, printed as it fills and left as CSV.
#pragma once

#include "table_row.hpp"

#include <string>
#include <string_view>

namespace experiments {

class report {
 public:
  void section(std::string_view title);  // prints a heading
  void add(const table_row& row);        // prints a line
  std::string csv() const { return csv_; }
  double most_power() const { return most_power_; }  // that a brake gave to its device [W]
  // Of the energy, for each joule that the brakes took.
  double worst_imbalance() const { return worst_imbalance_; }

 private:
  std::string csv_ = csv_head();
  double most_power_ = 0, worst_imbalance_ = 0;
};

}  // namespace experiments
