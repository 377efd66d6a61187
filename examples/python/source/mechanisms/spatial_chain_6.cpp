// A serial chain of 6 joints.
#include <precompiled.hpp>

#include "inverse.hpp"

#include <passive_haptics/mechanism/chains/serial_chain.hpp>

namespace passive_haptics_python {

void bind_spatial_chain_6(py::module_& module) {
  bind_mechanism<ph::serial_chain<double, 6, 3>, ph::serial_chain_parameters<double, 6, 3>>(
      module, "spatial_chain_6", "A serial chain of 6 joints in space, a brake on each.");
}

}  // namespace passive_haptics_python
