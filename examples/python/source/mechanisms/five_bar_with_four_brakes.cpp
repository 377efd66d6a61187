// A five-bar with redundant brakes.
#include <precompiled.hpp>

#include "inverse.hpp"

#include <passive_haptics/mechanism/models/five_bar.hpp>

namespace passive_haptics_python {

using device = ph::five_bar<double, 4>;
PASSIVE_HAPTICS_PYTHON_BATCHES_ELSEWHERE(device);

void bind_five_bar_with_four_brakes(py::module_& module) {
  auto bound = bind_mechanism<device, ph::five_bar_parameters<double, 4>>(
      module, "five_bar_with_four_brakes",
      "A five-bar with brakes on both base joints, their difference and their sum.");
  bind_usual_inverse(bound, "Base angles that put the handle at x [m], elbows outward");
}

}  // namespace passive_haptics_python
