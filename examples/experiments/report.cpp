#include "report.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

namespace experiments {

namespace {

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

}  // namespace

void report::section(std::string_view title) {
  std::printf("\n%.*s\n%-8s %-15s %-16s %-34s %5s %8s %8s %8s %8s %7s %7s %7s\n",
              static_cast<int>(title.size()), title.data(), "device", "wall", "environment", "law", "sepa-",
              "std", "range", "mean", "deepest", "brake 2", "retards", "brakes");
  std::printf("%-8s %-15s %-16s %-34s %5s %8s %8s %8s %8s %7s %7s %7s\n", "", "", "", "", "rat.", "[mm]",
              "[mm]", "[mm]", "[mm]", "sticks", "[N]", "[mJ]");
}

void report::add(const table_row& row) {
  const auto& f = row.figures;
  std::printf("%-8s %-15s %-16s %-34s %5d %8.3f %8.3f %8.3f %8.3f %5.0f %% %7.2f %7.1f%s\n",
              row.device.c_str(), row.wall.c_str(), row.environment.c_str(), row.law.c_str(), f.separations,
              1e3 * f.depth_std, 1e3 * f.depth_range, 1e3 * f.depth_mean, 1e3 * f.max_depth,
              100 * f.stick_share, f.retarding_force, 1e3 * f.brake_energy,
              f.arrived ? "" : ("  (" + std::string(to_string(f.end)) + ")").c_str());
  std::fflush(stdout);
  csv_ += csv_line(row);
  max_power_ = std::max(max_power_, f.max_brake_power);
  if (f.brake_energy > 0) max_imbalance_ = std::max(max_imbalance_, std::abs(row.imbalance) / f.brake_energy);
}

}  // namespace experiments
