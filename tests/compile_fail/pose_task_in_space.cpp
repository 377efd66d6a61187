// expect: passive_haptics: task_dimension must be 1, 2 or 3.*each component a length
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;

struct arm {
  using scalar = double;
  static constexpr int dof = 6, task_dimension = 6, brake_count = 6;
  ph::vector<double, 6> position(const ph::vector<double, 6>& q) const { return q; }
};

int main() { ph::device_state<arm> state; }
