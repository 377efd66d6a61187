// The wall calculator.
#include "module.hpp"

#include <passive_haptics_python/bind_design.hpp>

namespace passive_haptics_python {

void bind_walls_of_brakes(py::module_& module) {
  const std::string text =
      "(" + stub_arguments<ph::braked_wall>() +
      ")\n\nA wall at one place of a device, the hand that comes, and the control, along the "
      "wall's normal.\n\n" +
      parameter_lines<ph::braked_wall>();
  py::class_<braked_wall_value> bound(module, "braked_wall", text.c_str());
  add_value_protocol(bound, "braked_wall");
  module.def(
      "limits_of",
      [](py::handle wall) {
        const ph::wall_limits found = ph::limits_of(
            expect<braked_wall_value>(wall, "wall", "a braked_wall, as braked_wall_at() returns").table);
        return py::module_::import("passive_haptics.results")
            .attr("wall_limits")(found.depth, found.rigid_depth, found.stiffness, found.drift,
                                 found.pushed_out);
      },
      py::arg("wall"), "limits_of(wall: braked_wall) -> wall_limits\n\nWhat a wall made of brakes can be.");
}

}  // namespace passive_haptics_python
