#include <passive_haptics/passive_haptics.hpp>

#include <iostream>

namespace ph = passive_haptics;

class scara {
 public:
  using scalar = double;
  static constexpr int dof = 2, task_dimension = 2, brake_count = 2;

  template <class S>
  ph::vector<S, 2> position(const ph::vector<S, 2>& q) const {
    using std::cos, std::sin;
    return {0.2 * cos(q[0]) + 0.1 * cos(q[0] + q[1]), 0.2 * sin(q[0]) + 0.1 * sin(q[0] + q[1])};
  }
};

static_assert(ph::is_differentiable_mechanism<scara, ph::explain>());

int main() { std::cout << ph::jacobian(scara(), {0.3, 1.2}) << "\n"; }
