// The paper's device, with every law.
#include <precompiled.hpp>

#include "inverse.hpp"

#include <passive_haptics/mechanism/models/tendon_two_link.hpp>

namespace passive_haptics_python {

using arm = ph::tendon_two_link<double>;
using all_laws = law_list<ph::direct_control, ph::saturated_direct_control, ph::velocity_direct_control,
                          ph::no_direct_control, ph::on_off_control>;
PASSIVE_HAPTICS_PYTHON_BATCHES_ELSEWHERE(ph::tendon_two_link<double>);

void bind_tendon_two_link(py::module_& module) {
  auto bound = bind_mechanism<arm, ph::tendon_two_link_parameters<double>, all_laws>(
      module, "tendon_two_link",
      "The paper's device: two links, both brakes at the base, coupled by tendons.");
  bind_two_link_inverse(bound);
}

}  // namespace passive_haptics_python
