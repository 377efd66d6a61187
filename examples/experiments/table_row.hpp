// One line of a table of runs, as CSV.
#pragma once

#include "planar.hpp"

#include <string>

namespace experiments {

// Figures of one run, or of one of its walls.
struct table_row {
  std::string device, wall, environment, law;  // environment: what slows the wall down
  ph::contact_metrics figures;
  double imbalance = 0;  // of the energy [J]
};

// The names of the columns, and a row; both end in a new line.
std::string csv_head();
std::string csv_line(const table_row& row);

}  // namespace experiments
