// expect: passive_haptics: position\(q\) must be const.*not an Eigen expression
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;

struct arm {
  using scalar = double;
  static constexpr int dof = 2, task_dimension = 2, brake_count = 2;
  auto position(const ph::vector<double, 2>& q) const { return 2 * q; }
};

ph::sensorless_device_state<arm> state;
