// expect: passive_haptics: this law needs a mechanism that models Dynamics: give it mass_matrix
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;

struct arm {
  using scalar = double;
  static constexpr int dof = 2, task_dimension = 2, brake_count = 2;
  template <class S>
  ph::vector<S, 2> position(const ph::vector<S, 2>& q) const {
    return q;
  }
};

int main() {
  ph::controller control(arm(), ph::brakes_of<arm>(), ph::scene(ph::wall(ph::half_space<2>({0, 1}, {0, -1}))),
                         ph::velocity_direct_control());
  control(ph::device_state<arm>());
}
