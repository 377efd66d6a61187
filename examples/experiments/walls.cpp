// The walls of the experiments in the plane.
#include "planar.hpp"

#include <cmath>

namespace experiments {

test_wall planar_wall(double slant) {
  return test_wall(ph::half_space<2>({0, 0.225}, {std::sin(slant), -std::cos(slant)}));
}
test_wall concave_wall() { return test_wall(ph::disc({0.11, -0.10}, 0.325, ph::filling::hollow)); }
test_wall convex_wall() { return test_wall(ph::disc({0.11, 0.55}, 0.325)); }

}  // namespace experiments
