// Devices in the plane with a brake on each of two joints: what is compiled for their size serves both.
#include <precompiled.hpp>

#include "any_devices.hpp"
#include "inverse.hpp"

#include <passive_haptics/mechanism/models/five_bar.hpp>

namespace passive_haptics_python {

using five_bar = ph::five_bar<double, 2>;
PASSIVE_HAPTICS_PYTHON_BATCHES_ELSEWHERE(ph::two_link<double>);
PASSIVE_HAPTICS_PYTHON_BATCHES_ELSEWHERE(five_bar);

std::unique_ptr<any_device> device_for(any_pair mechanism, bool has_inertia) {
  return std::make_unique<device_of<any_pair, any_device_laws>>(std::move(mechanism), has_inertia);
}

void bind_planar_pairs(py::module_& module) {
  auto arm = bind_mechanism<ph::two_link<double>, ph::two_link_parameters<double>,
                            usual_laws<ph::two_link<double>>, any_pair, any_device_laws>(
      module, "two_link", "Two links in a plane, a brake on each joint.");
  bind_two_link_inverse(arm);
  auto legs =
      bind_mechanism<five_bar, ph::five_bar_parameters<double, 2>, usual_laws<five_bar>, any_pair,
                     any_device_laws>(module, "five_bar", "Two legs that meet at the handle (pantograph).");
  bind_usual_inverse(legs, "Base angles that put the handle at x [m], elbows outward");
}

}  // namespace passive_haptics_python
