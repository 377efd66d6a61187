// expect: passive_haptics: the mechanism needs jacobian\(q\), or position\(q\) templated on the scalar
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;

struct arm {
  using scalar = double;
  static constexpr int dof = 2, task_dimension = 2, brake_count = 2;
  ph::vector<double, 2> position(const ph::vector<double, 2>& q) const { return q; }
};

int main() { ph::jacobian(arm(), ph::vector<double, 2>(0, 0)); }
