// Names of the laws, and the walls.
#include "planar.hpp"

#include <cmath>

namespace experiments {

std::string_view name_of(law which) {
  switch (which) {
    case law::none: return "no_direct_control";
    case law::direct: return "direct_control";
    case law::saturated: return "saturated_direct_control";
    case law::direct_dead_band: return "direct_control, dead band";
    case law::velocity: return "velocity_direct_control";
    case law::velocity_on_touch: return "velocity_direct_control, on touch";
    case law::coercive: return "coercive_force_approximation";
    case law::single_degree_of_freedom: return "single_degree_of_freedom_control";
    case law::velocity_ratio: return "velocity_ratio_control";
    case law::on_off: return "on_off_control";
    case law::bang_bang: return "bang_bang_control";
  }
  return "unknown law";
}

test_wall planar_wall(double slant) {
  return test_wall(ph::half_space<2>({0, 0.225}, {std::sin(slant), -std::cos(slant)}));
}
test_wall concave_wall() { return test_wall(ph::disc({0.11, -0.10}, 0.325, ph::filling::hollow)); }
test_wall convex_wall() { return test_wall(ph::disc({0.11, 0.55}, 0.325)); }

}  // namespace experiments
