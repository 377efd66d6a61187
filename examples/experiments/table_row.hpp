// One line of a table of runs, as CSV.
#pragma once

#include "planar.hpp"

#include <string>

namespace experiments {

// Figures of one run, or of one of its walls.
struct table_row {
  std::string device, wall, environment, law;  // environment: delay of the wall
  ph::contact_metrics figures;
  double imbalance = 0;  // of the energy [J]
};

// Header and row, each with a newline.
std::string csv_head();
std::string csv_line(const table_row& row);

}  // namespace experiments
