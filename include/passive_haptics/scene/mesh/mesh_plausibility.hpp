/// Plausibility checks of a mesh.
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/scene/mesh/mesh.hpp>

#include <string>

namespace passive_haptics {

/// Returns a line for each implausible property of a mesh for a device with this reach [m]: a size of more
/// than 10 times or less than 1/500 of the reach, a closed mesh that is inside out, facets of opposite
/// orientation to their neighbours. Throws std::invalid_argument if the reach is not a finite number > 0. For
/// set-up.
template <int D>
std::string plausibility(const mesh<D>& m, double reach) {
  constexpr double largest = 10, smallest = 1.0 / 500;  // fractions of the reach
  require_no_error(check_value("reach", reach, "m", range::positive));
  std::string all;
  const auto remark = [&](const char* what, auto value, const std::string& usually) {
    all.append(detail::indexed(what, value, ", usually ")).append(usually).append("\n");
  };
  const double size = (m.bounds().upper - m.bounds().lower).maxCoeff();
  if (size > largest * reach)
    remark("size of the mesh [m] = ", size,
           detail::indexed("up to ", largest * reach,
                           ": a file in millimetres, whose metres_per_unit is 1e-3?"));
  if (size < smallest * reach)
    remark("size of the mesh [m] = ", size,
           detail::indexed("over ", smallest * reach, ": a file in metres, whose metres_per_unit is 1?"));
  if (m.closed() && m.content() < 0)
    remark(D == 2 ? "area within the mesh [m^2] = " : "volume within the mesh [m^3] = ", m.content(),
           "> 0: inside out? If the hand is outside, swap two corners of each facet");
  if (m.turned_edges() > 0)
    remark("edges whose facets face opposite sides = ", m.turned_edges(),
           "0: facets inside out? A handle that comes from their back goes through");
  return all;
}

}  // namespace passive_haptics
