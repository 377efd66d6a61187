// The module _native of the package passive_haptics.
#include <precompiled.hpp>

#include "module.hpp"

#include <passive_haptics/core/status.hpp>
#include <passive_haptics/core/version.hpp>
#include <passive_haptics/force/classification.hpp>
#include <passive_haptics/plant/contact_metrics.hpp>

#include <string>

namespace py = pybind11;
namespace ph = passive_haptics;

PYBIND11_MODULE(_native, module) {
  using namespace passive_haptics_python;
  py::options options;
  options.disable_function_signatures();  // the first line of each text is one, for the stubs
  module.doc() = "The classes of passive_haptics, bound to Python.";
  module.attr("__version__") = std::to_string(PASSIVE_HAPTICS_VERSION_MAJOR) + "." +
                               std::to_string(PASSIVE_HAPTICS_VERSION_MINOR) + "." +
                               std::to_string(PASSIVE_HAPTICS_VERSION_PATCH);
  module.def(
      "status_text", [](int value) { return std::string(ph::to_string(ph::status(value))); },
      py::arg("value"), "status_text(value: int) -> str\n\nA status in words.");
  module.def(
      "power_text", [](int value) { return std::string(ph::to_string(ph::power_class(value))); },
      py::arg("value"), "power_text(value: int) -> str\n\nA power class in words.");
  module.def(
      "display_text", [](int value) { return std::string(ph::to_string(ph::display_class(value))); },
      py::arg("value"), "display_text(value: int) -> str\n\nA display class in words.");
  module.def(
      "run_end_text", [](int value) { return std::string(ph::to_string(ph::run_end(value))); },
      py::arg("value"), "run_end_text(value: int) -> str\n\nThe end of a run in words.");
  for (const auto bind : {bind_shapes,
                          bind_laws,
                          bind_mechanisms,
                          bind_states,
                          bind_batches,
                          bind_controllers,
                          bind_walls_of_brakes,
                          bind_brake_models,
                          bind_simulations,
                          bind_tendon_two_link,
                          bind_planar_pairs,
                          bind_xy_table,
                          bind_five_bar_with_four_brakes,
                          bind_delta,
                          bind_planar_chains_3,
                          bind_planar_chains_4,
                          bind_spatial_chains_3,
                          bind_spatial_chain_6,
                          bind_spatial_chain_7,
                          bind_logs,
                          bind_python_mechanism})
    bind(module);
}
