// Serial chains of 4 joints in the plane.
#include <precompiled.hpp>

#include "chains.hpp"

namespace passive_haptics_python {

std::unique_ptr<any_device> device_for(any_mechanism<4, 2> mechanism, bool has_inertia) {
  return std::make_unique<device_of<any_mechanism<4, 2>, any_device_laws>>(std::move(mechanism), has_inertia);
}

void bind_planar_chains_4(py::module_& module) {
  bind_chains<4, 2>(module, "planar_chain_4", "A serial chain of 4 joints in the plane");
}

}  // namespace passive_haptics_python
