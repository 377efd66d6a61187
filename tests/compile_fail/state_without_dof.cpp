// expect: passive_haptics: the mechanism needs `static constexpr int dof`
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;

struct arm {
  using scalar = double;
  static constexpr int task_dimension = 2, brake_count = 2;
  ph::vector<double, 2> position(const ph::vector<double, 2>& q) const { return q; }
};

ph::device_state<arm> state;
