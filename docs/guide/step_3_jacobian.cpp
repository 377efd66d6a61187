#include <passive_haptics/passive_haptics.hpp>

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

  ph::matrix<double, 2, 2> jacobian(const ph::vector<double, 2>& q) const {
    const ph::vector<double, 2> x = position(q);
    const ph::vector<double, 2> outer =
        0.1 * ph::vector<double, 2>(std::cos(q[0] + q[1]), std::sin(q[0] + q[1]));
    return ph::matrix<double, 2, 2>{{-x[1], -outer[1]}, {x[0], outer[0]}};
  }
};

static_assert(ph::describe<scara>().has("jacobian"));

int main() {
  const ph::vector<double, 2> q(0.3, 1.2);
  const ph::matrix<double, 2, 2> given = ph::jacobian(scara(), q),
                                 automatic = ph::automatic_jacobian(scara(), q);
  return given.isApprox(automatic, 1e-14) ? 0 : 1;
}
