/// @file
/// The parts of the module, in the order in which they are bound.
#pragma once

#include <pybind11/pybind11.h>

namespace passive_haptics_python {

struct mechanism;

// Each binds one kind of classes.
void bind_shapes(pybind11::module_& module);
void bind_laws(pybind11::module_& module);
void bind_mechanisms(pybind11::module_& module);
void bind_brake_models(pybind11::module_& module);
void bind_simulations(pybind11::module_& module);
void bind_states(pybind11::module_& module);
void bind_batches(pybind11::module_& module);
void bind_controllers(pybind11::module_& module);
void bind_walls_of_brakes(pybind11::module_& module);
void bind_logs(pybind11::module_& module);
void bind_python_mechanism(pybind11::module_& module);

// Each binds what walls are made of, or into.
void bind_meshes(pybind11::module_& module);
void bind_walls(pybind11::module_& module);
void bind_scenes(pybind11::module_& module);
void bind_effects(pybind11::module_& module);
void bind_with_effects(pybind11::module_& module);

// Binds the functions of design/ to the class of all mechanisms.
void bind_design(pybind11::class_<mechanism>& bound);

// Each binds mechanisms of the library.
void bind_tendon_two_link(pybind11::module_& module);
void bind_planar_pairs(pybind11::module_& module);
void bind_xy_table(pybind11::module_& module);
void bind_five_bar_with_four_brakes(pybind11::module_& module);
void bind_delta(pybind11::module_& module);
void bind_planar_chains_3(pybind11::module_& module);
void bind_planar_chains_4(pybind11::module_& module);
void bind_spatial_chains_3(pybind11::module_& module);
void bind_spatial_chain_6(pybind11::module_& module);
void bind_spatial_chain_7(pybind11::module_& module);

}  // namespace passive_haptics_python
