// expect: passive_haptics: this drops the derivatives of position.q.: write `using std::cos
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;

struct arm {
  using scalar = double;
  static constexpr int dof = 2, task_dimension = 2, brake_count = 2;
  template <class S>
  ph::vector<S, 2> position(const ph::vector<S, 2>& q) const {
    return {std::cos(q[0]), std::sin(q[1])};
  }
};

const auto J = ph::jacobian(arm(), {0.3, 1});
