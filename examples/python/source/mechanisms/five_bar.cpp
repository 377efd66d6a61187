// A five-bar with two brakes.
#include "inverse.hpp"

#include <passive_haptics/mechanism/models/five_bar.hpp>

namespace passive_haptics_python {

using device = ph::five_bar<double, 2>;
PASSIVE_HAPTICS_PYTHON_BATCHES_ELSEWHERE(device);

void bind_five_bar(py::module_& module) {
  auto bound = bind_mechanism<device, ph::five_bar_parameters<double, 2>>(
      module, "five_bar", "Two legs that meet at the handle (pantograph).");
  bind_usual_inverse(bound, "Base angles that put the handle at x [m], elbows outward");
}

}  // namespace passive_haptics_python
