// expect: passive_haptics: kinetostatic.mechanism. is for mechanisms with dof > task_dimension
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;

struct arm {
  using scalar = double;
  static constexpr int dof = 2, task_dimension = 2, brake_count = 2;
  template <class S>
  ph::vector<S, 2> position(const ph::vector<S, 2>& q) const {
    return q.template head<2>();
  }
};

int main() {
  ph::controller control(ph::kinetostatic(arm()), ph::brakes_of<arm>(),
                         ph::scene(ph::wall(ph::half_space<2>({0, 1}, {0, -1}))), ph::direct_control());
}
