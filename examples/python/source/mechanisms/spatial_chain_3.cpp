// A serial chain of 3 joints.
#include "inverse.hpp"

#include <passive_haptics/mechanism/chains/serial_chain.hpp>

namespace passive_haptics_python {

void bind_spatial_chain_3(py::module_& module) {
  bind_mechanism<ph::serial_chain<double, 3, 3>, ph::serial_chain_parameters<double, 3, 3>>(
      module, "spatial_chain_3", "A serial chain of 3 joints in space, a brake on each.");
}

}  // namespace passive_haptics_python
