// A serial chain of 7 joints.
#include <precompiled.hpp>

#include "any_devices.hpp"
#include "inverse.hpp"

#include <passive_haptics/mechanism/chains/serial_chain.hpp>

namespace passive_haptics_python {

std::unique_ptr<any_device> device_for(any_long_chain<7> mechanism, bool has_inertia) {
  return std::make_unique<device_of<any_long_chain<7>, massless_device_laws>>(std::move(mechanism),
                                                                              has_inertia);
}

void bind_spatial_chain_7(py::module_& module) {
  using chain = ph::serial_chain<double, 7, 3>;
  bind_mechanism<chain, ph::serial_chain_parameters<double, 7, 3>, usual_laws<chain>, any_long_chain<7>,
                 massless_device_laws>(module, "spatial_chain_7",
                                       "A serial chain of 7 joints in space, a brake on each.");
}

}  // namespace passive_haptics_python
