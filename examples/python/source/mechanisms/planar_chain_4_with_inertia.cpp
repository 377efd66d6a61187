// A serial chain of 4 joints with inertia.
#include "chain_with_inertia.hpp"

namespace passive_haptics_python {

void bind_planar_chain_4_with_inertia(py::module_& module) {
  bind_chain_with_inertia<4, 2>(module, "planar_chain_4_with_inertia",
                                "A serial chain of 4 joints in the plane, a brake on each, with inertia.");
}

}  // namespace passive_haptics_python
