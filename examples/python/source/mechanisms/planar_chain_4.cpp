// A serial chain of 4 joints.
#include "inverse.hpp"

#include <passive_haptics/mechanism/chains/serial_chain.hpp>

namespace passive_haptics_python {

void bind_planar_chain_4(py::module_& module) {
  bind_mechanism<ph::serial_chain<double, 4, 2>, ph::serial_chain_parameters<double, 4, 2>>(
      module, "planar_chain_4", "A serial chain of 4 joints in the plane, a brake on each.");
}

}  // namespace passive_haptics_python
