// A serial chain of 3 joints with inertia.
#include "chain_with_inertia.hpp"

namespace passive_haptics_python {

void bind_spatial_chain_3_with_inertia(py::module_& module) {
  bind_chain_with_inertia<3, 3>(module, "spatial_chain_3_with_inertia",
                                "A serial chain of 3 joints in space, a brake on each, with inertia.");
}

}  // namespace passive_haptics_python
