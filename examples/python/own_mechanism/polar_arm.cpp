// A mechanism of your own for Python: a link that turns and slides, a brake on each joint.
#include <passive_haptics_python/add_mechanism.hpp>

struct polar_arm {
  using scalar = double;
  static constexpr int dof = 2, task_dimension = 2, brake_count = 2;

  template <class S>
  passive_haptics::vector<S, 2> position(const passive_haptics::vector<S, 2>& q) const {
    using std::cos, std::sin;
    return {q[1] * cos(q[0]), q[1] * sin(q[0])};
  }
};

PYBIND11_MODULE(polar, module) {
  passive_haptics_python::add_mechanism<polar_arm>(module, "polar_arm", "A link that turns and slides.");
}
