// One table of all runs, printed while it is filled and stored as CSV.
#pragma once

#include "planar.hpp"

#include <string>
#include <string_view>

namespace experiments {

// Figures of one run, or of one of its walls.
struct table_row {
  std::string device, wall, environment, law;  // environment: delay of the wall
  ph::contact_metrics figures;
  double imbalance = 0;  // of the energy [J]
};

class report {
 public:
  void section(std::string_view title);  // prints a heading
  void add(const table_row& row);        // prints a line
  std::string csv() const { return csv_; }
  double max_power() const { return max_power_; }  // of a brake on its device [W]
  // Of the energy, per joule dissipated by the brakes.
  double max_imbalance() const { return max_imbalance_; }

 private:
  std::string csv_ =
      "device, wall, environment, law, separations, depth standard deviation [mm], depth range [mm], "
      "depth mean [mm], depth max [mm], brake 2 sticks [%], retarding force [N], brake energy [mJ], "
      "duration [s], arrived\n";
  double max_power_ = 0, max_imbalance_ = 0;
};

}  // namespace experiments
