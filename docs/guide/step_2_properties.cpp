#include <passive_haptics/passive_haptics.hpp>
#include <passive_haptics/testing/mechanism_properties.hpp>

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

struct scara_case {
  using mechanism = scara;
  static scara make() { return scara(); }
  static ph::vector<double, 2> lower() { return {-3, -3}; }
  static ph::vector<double, 2> upper() { return {3, 3}; }
};

namespace passive_haptics::testing {
INSTANTIATE_TYPED_TEST_SUITE_P(scara, mechanism_properties, scara_case);
}
