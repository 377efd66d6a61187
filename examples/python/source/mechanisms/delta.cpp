// Three arms that move a platform in space.
#include <precompiled.hpp>

#include "inverse.hpp"

#include <passive_haptics/mechanism/models/delta.hpp>

namespace passive_haptics_python {

using device = ph::delta<double>;
PASSIVE_HAPTICS_PYTHON_BATCHES_ELSEWHERE(device);

void bind_delta(py::module_& module) {
  auto bound = bind_mechanism<device, ph::delta_parameters<double>>(
      module, "delta", "Three arms that move a platform in space without turning it.");
  bind_usual_inverse(bound, "Base angles that put the platform at x [m], elbows outward");
}

}  // namespace passive_haptics_python
