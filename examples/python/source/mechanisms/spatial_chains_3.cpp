// Serial chains of 3 joints in space.
#include <precompiled.hpp>

#include "chains.hpp"

namespace passive_haptics_python {

void bind_spatial_chains_3(py::module_& module) {
  bind_chains<3, 3>(module, "spatial_chain_3", "A serial chain of 3 joints in space");
}

}  // namespace passive_haptics_python
