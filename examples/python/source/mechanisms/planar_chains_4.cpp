// Serial chains of 4 joints in the plane.
#include <precompiled.hpp>

#include "chains.hpp"

namespace passive_haptics_python {

void bind_planar_chains_4(py::module_& module) {
  bind_chains<4, 2>(module, "planar_chain_4", "A serial chain of 4 joints in the plane");
}

}  // namespace passive_haptics_python
