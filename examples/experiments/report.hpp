// One table of all runs, printed while it is filled and stored as CSV.
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
  double max_power() const { return max_power_; }  // of a brake on its device [W]
  // Of the energy, per joule dissipated by the brakes.
  double max_imbalance() const { return max_imbalance_; }

 private:
  std::string csv_ = csv_head();
  double max_power_ = 0, max_imbalance_ = 0;
};

}  // namespace experiments
