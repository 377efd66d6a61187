#include "table_row.hpp"

#include <sstream>

namespace experiments {

std::string csv_head() {
  return "device, wall, environment, law, separations, depth standard deviation [mm], depth range [mm], "
         "depth mean [mm], depth max [mm], brake 2 sticks [%], retarding force [N], brake energy [mJ], "
         "duration [s], arrived\n";
}

std::string csv_line(const table_row& row) {
  const auto& f = row.figures;
  std::ostringstream line;
  line << row.device << ", " << row.wall << ", " << row.environment << ", " << row.law << ", "
       << f.separations << ", " << 1e3 * f.depth_std << ", " << 1e3 * f.depth_range << ", "
       << 1e3 * f.depth_mean << ", " << 1e3 * f.max_depth << ", " << 100 * f.stick_share << ", "
       << f.retarding_force << ", " << 1e3 * f.brake_energy << ", " << f.duration << ", "
       << (f.arrived ? "yes" : "no") << "\n";
  return line.str();
}

}  // namespace experiments
