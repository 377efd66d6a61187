// expect: passive_haptics: a simulated device needs a mechanism that models Dynamics
#include <passive_haptics/passive_haptics.hpp>
#include <passive_haptics/plant/simulated_device.hpp>

namespace ph = passive_haptics;

struct arm {
  using scalar = double;
  static constexpr int dof = 2, task_dimension = 2, brake_count = 2;
  template <class S>
  ph::vector<S, 2> position(const ph::vector<S, 2>& q) const {
    return q;
  }
};

int main() { ph::simulated_device<arm> device(arm(), ph::brakes_of<arm>(), 0, {0, 0}); }
