// expect: passive_haptics: single_degree_of_freedom_control needs
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;

struct arm {
  using scalar = double;
  static constexpr int dof = 3, task_dimension = 2, brake_count = 3;
  ph::vector<double, 2> position(const ph::vector<double, 3>& q) const { return {q[0], q[1] + q[2]}; }
  ph::matrix<double, 2, 3> jacobian() const { return ph::matrix<double, 2, 3>{{1, 0, 0}, {0, 1, 1}}; }
};

int main() {
  ph::controller control(arm(), ph::brakes_of<arm>(), ph::scene(ph::wall(ph::disc({0, 0}, 1))),
                         ph::single_degree_of_freedom_control());
  control(ph::device_state<arm>());
}
