// Two orthogonal slides, a brake on each.
#include <precompiled.hpp>

#include "inverse.hpp"

#include <passive_haptics/mechanism/models/xy_table.hpp>

namespace passive_haptics_python {

PASSIVE_HAPTICS_PYTHON_BATCHES_ELSEWHERE(ph::xy_table<double>);

void bind_xy_table(py::module_& module) {
  auto bound = bind_mechanism<ph::xy_table<double>, ph::xy_table_parameters<double>>(
      module, "xy_table", "Two orthogonal slides, a brake on each.");
  bind_usual_inverse(bound, "Joint positions that put the handle at x [m]");
}

}  // namespace passive_haptics_python
