// A serial chain of 7 joints.
#include <precompiled.hpp>

#include "inverse.hpp"

#include <passive_haptics/mechanism/chains/serial_chain.hpp>

namespace passive_haptics_python {

void bind_spatial_chain_7(py::module_& module) {
  bind_mechanism<ph::serial_chain<double, 7, 3>, ph::serial_chain_parameters<double, 7, 3>>(
      module, "spatial_chain_7", "A serial chain of 7 joints in space, a brake on each.");
}

}  // namespace passive_haptics_python
