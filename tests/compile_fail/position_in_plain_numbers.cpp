// expect: cannot convert .*dual_number.* to .*double|no viable conversion from .*dual_number.* to .*double
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;

struct arm {
  using scalar = double;
  static constexpr int dof = 2, task_dimension = 2, brake_count = 2;
  template <class S>
  ph::vector<S, 2> position(const ph::vector<S, 2>& q) const {
    const double angle = q[0];
    return {q[1], S(angle)};
  }
};

const auto J = ph::jacobian(arm(), {0.3, 1});
