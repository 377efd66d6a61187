// One table of all runs, printed as it fills and left as CSV.
#pragma once

#include "planar.hpp"

#include <sstream>
#include <string>
#include <string_view>

namespace experiments {

// Figures of one run, or of one of its walls.
struct table_row {
  std::string device, wall, environment, law;  // environment: what slows the wall down
  ph::contact_metrics figures;
  double imbalance = 0;  // of the energy [J]
};

class report {
 public:
  report();
  void section(std::string_view title);  // prints a heading
  void add(const table_row& row);        // prints a line
  std::string csv() const { return csv_.str(); }
  double most_power() const { return most_power_; }  // that a brake gave to its device [W]
  // Of the energy, for each joule that the brakes took.
  double worst_imbalance() const { return worst_imbalance_; }

 private:
  std::ostringstream csv_;
  double most_power_ = 0, worst_imbalance_ = 0;
};

}  // namespace experiments
