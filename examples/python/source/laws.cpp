// Control laws.
#include <precompiled.hpp>

#include "module.hpp"

#include <passive_haptics_python/laws.hpp>

#include <passive_haptics/control/laws/on_off_control.hpp>

namespace passive_haptics_python {
namespace {

template <class L>
void bind_law(py::module_& module, const std::string& name, const std::string& about) {
  using P = law_parameters<L>;
  const std::string text = "(" + stub_arguments<P>() + ")\n\n" + about + "\n\n" + parameter_lines<P>();
  py::class_<law_value<L>, law> bound(module, name.c_str(), text.c_str());
  add_value_protocol(bound, name);
}

}  // namespace

void bind_laws(py::module_& module) {
  py::class_<law>(module, "law", "A control law.");
  bind_law<ph::direct_control>(module, "direct_control", "The paper's direct control (7)-(12).");
  bind_law<ph::saturated_direct_control>(
      module, "saturated_direct_control",
      "Direct control whose alpha scales torques that are already cut to the limits. One wall.");
  bind_law<ph::velocity_direct_control>(
      module, "velocity_direct_control",
      "The law that recommended_law returns for a mechanism with inertia and a force sensor.");
  bind_law<ph::on_off_control>(
      module, "on_off_control",
      "The whole approximated force or none, by a relay. recommended_law for a mechanism without inertia.");
  bind_law<ph::no_direct_control>(module, "no_direct_control", "The approximated force as it is, alpha = 1.");
}

}  // namespace passive_haptics_python
