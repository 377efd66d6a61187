// expect: passive_haptics: this mechanism has more joints than task dimensions and no inertia. Give it
// mass_matrix, .*kinetostatic.mechanism.
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;

struct arm {
  using scalar = double;
  static constexpr int dof = 3, task_dimension = 2, brake_count = 3;
  template <class S>
  ph::vector<S, 2> position(const ph::vector<S, 3>& q) const {
    return q.template head<2>();
  }
};

int main() {
  ph::controller control(arm(), ph::brakes_of<arm>(), ph::scene(ph::wall(ph::half_space<2>({0, 1}, {0, -1}))),
                         ph::direct_control());
}
