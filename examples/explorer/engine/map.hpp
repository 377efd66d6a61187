/// @file
/// The design map of a device over a grid of points.
#pragma once

#include "parts.hpp"

#include <array>
#include <vector>

namespace explorer {

/// Angle and class of what is displayed (passive_haptics::displayable()) at each point of a grid that a
/// device reaches, for a hand that moves and pushes along map.direction and map.normal.
class figure_map {
 public:
  /// With columns x rows points from low to high, in space at the height of the present handle.
  figure_map(const configuration& c, int columns, int rows, const place& low, const place& high);
  /// Computes rows; returns those that are done.
  int advance(int rows);
  /// rows x columns numbers from low y upwards, NaN out of reach. 0: the cosine of the angle; 1: the class.
  const std::vector<double>& figure(int number) const { return figures_[std::size_t(number)]; }

 private:
  void compute(int column, int row);

  device_parts of_;
  int columns_, rows_, done_ = 0;
  place low_, high_;
  std::array<std::vector<double>, 2> figures_;
};

}  // namespace explorer
