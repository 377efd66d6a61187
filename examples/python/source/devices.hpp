/// @file
/// What sources share that take a mechanism, brakes or a controller from Python.
#pragma once

#include <passive_haptics_python/mechanisms.hpp>

namespace passive_haptics_python {

/// The parameters of brakes that must be those of a device; a TypeError if they are not.
brake_numbers brakes_for(const mechanism& of, const py::object& given);

/// Lets other threads of Python run, and throws KeyboardInterrupt after Ctrl-C.
inline void let_others_run() {
  {
    const py::gil_scoped_release unlocked;
  }
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
}

/// x as a vector of any length.
inline numbers any_numbers(py::handle x, const char* name) { return vector_from<Eigen::Dynamic>(x, name); }

/// The controller that a Python user passes, which must be of a device of these sizes.
any_controller& controller_for(const device_sizes& sizes, py::handle given);

/// The brakes that a Python user passes as a list of brake models.
std::vector<run_time_brake> brake_models_from(py::handle given);

}  // namespace passive_haptics_python
