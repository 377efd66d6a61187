// Serial chains of 3 joints in space.
#include <precompiled.hpp>

#include "chains.hpp"

namespace passive_haptics_python {

std::unique_ptr<any_device> device_for(any_mechanism<3, 3> mechanism, bool has_inertia) {
  return std::make_unique<device_of<any_mechanism<3, 3>, any_device_laws>>(std::move(mechanism), has_inertia);
}

void bind_spatial_chains_3(py::module_& module) {
  bind_chains<3, 3>(module, "spatial_chain_3", "A serial chain of 3 joints in space");
}

}  // namespace passive_haptics_python
