// The surface of a wall as a curve y(x), for pictures.
#pragma once

#include "planar.hpp"

#include <algorithm>

namespace experiments {

// y [m] of the surface above x [m]; Newton's method from inside the device's workspace.
inline double surface_height(const test_wall& wall, double x) {
  plane_vector at(x, 0.2);
  for (int k = 0; k < 50; ++k) at[1] += wall.distance(at) / std::max(0.2, -wall.gradient(at)[1]);
  return at[1];
}

}  // namespace experiments
