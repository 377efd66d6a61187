// Serial chains of 3 joints in the plane.
#include <precompiled.hpp>

#include "chains.hpp"

namespace passive_haptics_python {

void bind_planar_chains_3(py::module_& module) {
  bind_chains<3, 2>(module, "planar_chain_3", "A serial chain of 3 joints in the plane");
}

}  // namespace passive_haptics_python
