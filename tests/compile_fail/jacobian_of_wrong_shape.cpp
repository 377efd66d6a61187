// expect: passive_haptics: jacobian must be const.*matrix<scalar, task_dimension, dof> exactly
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;

struct arm {
  using scalar = double;
  static constexpr int dof = 2, task_dimension = 2, brake_count = 2;
  ph::vector<double, 2> position(const ph::vector<double, 2>& q) const { return q; }
  ph::matrix<double, 2, 3> jacobian(const ph::vector<double, 2>&) const { return {}; }
};

int main() {
  ph::controller control(arm(), ph::brakes_of<arm>(), ph::scene(ph::wall(ph::disc({0, 0}, 1))),
                         ph::no_direct_control{});
}
