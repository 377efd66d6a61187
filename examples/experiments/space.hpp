// Beyond the paper: three degrees of freedom, a plane, spheres, and the edge of two planes.
#pragma once

#include "planar.hpp"

#include <string>
#include <utility>
#include <vector>

namespace experiments {

enum class space_device { delta, arm_3r };
enum class space_wall { plane, solid_sphere, hollow_sphere, edge_90, edge_120 };
inline constexpr std::array space_devices{space_device::delta, space_device::arm_3r};
inline constexpr std::array space_walls{space_wall::plane, space_wall::solid_sphere,
                                        space_wall::hollow_sphere, space_wall::edge_90, space_wall::edge_120};
inline constexpr std::array space_laws{law::none, law::direct, law::velocity};
std::string_view name_of(space_device which);
std::string_view name_of(space_wall which);

struct space_result {
  std::vector<ph::contact_metrics> figures;  // of each wall, two for an edge
  std::vector<std::pair<double, std::vector<double>>>
      trace;  // distance along the path [m], depth in each wall [m]
  ph::energy_balance energy;
};

// A hand of 0.5 kg moves the handle along x at 0.05 m/s over the middle of the workspace, 0.1 m for the arm
// and 0.06 m for the delta, with a push of 2 N into each wall; it starts 4 mm above them at 0.1 m/s.
space_result follow_in_space(space_device device, space_wall wall, law which, const setup& how);

}  // namespace experiments
