// expect: passive_haptics: unsupported sizes; needed are brake_count == dof >= task_dimension
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;

struct arm {
  using scalar = double;
  static constexpr int dof = 2, task_dimension = 3, brake_count = 2;
  ph::vector<double, 3> position(const ph::vector<double, 2>&) const { return {}; }
};

ph::step_result<arm> result;
