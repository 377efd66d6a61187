// Two links in a plane, a brake on each joint.
#include "inverse.hpp"

namespace passive_haptics_python {

PASSIVE_HAPTICS_PYTHON_BATCHES_ELSEWHERE(ph::two_link<double>);

void bind_two_link(py::module_& module) {
  auto bound = bind_mechanism<ph::two_link<double>, ph::two_link_parameters<double>>(
      module, "two_link", "Two links in a plane, a brake on each joint.");
  bind_two_link_inverse(bound);
}

}  // namespace passive_haptics_python
