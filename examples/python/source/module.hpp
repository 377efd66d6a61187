/// @file
/// The parts of the module, in the order in which they are bound.
#pragma once

#include <pybind11/pybind11.h>

namespace passive_haptics_python {

// Each binds one kind of classes.
void bind_shapes(pybind11::module_& module);
void bind_laws(pybind11::module_& module);
void bind_states(pybind11::module_& module);
void bind_batches(pybind11::module_& module);
void bind_controllers(pybind11::module_& module);
void bind_walls_of_brakes(pybind11::module_& module);

// Each binds a mechanism of the library.
void bind_tendon_two_link(pybind11::module_& module);
void bind_two_link(pybind11::module_& module);
void bind_xy_table(pybind11::module_& module);
void bind_five_bar(pybind11::module_& module);
void bind_five_bar_with_four_brakes(pybind11::module_& module);
void bind_delta(pybind11::module_& module);
void bind_planar_chain_3(pybind11::module_& module);
void bind_planar_chain_4(pybind11::module_& module);
void bind_spatial_chain_3(pybind11::module_& module);
void bind_spatial_chain_6(pybind11::module_& module);
void bind_spatial_chain_7(pybind11::module_& module);
void bind_planar_chain_3_with_inertia(pybind11::module_& module);
void bind_planar_chain_4_with_inertia(pybind11::module_& module);
void bind_spatial_chain_3_with_inertia(pybind11::module_& module);

}  // namespace passive_haptics_python
