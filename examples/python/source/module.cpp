// The module _native of the package passive_haptics: what its Python is made of. Its classes are not for
// users.
#include "devices.hpp"

#include <catalogue/catalogue.hpp>

#include <passive_haptics/core/version.hpp>
#include <passive_haptics/runtime/device_file/read_device.hpp>

#include <pybind11/stl.h>

namespace passive_haptics_python {
namespace {

// A device file as names and dictionaries.
py::dict read_device(const std::string& path) {
  const rt::toml_section file = rt::toml_section::file(path);
  rt::device_description of = rt::read_device(file, example::catalogue());
  const auto pair = [](rt::named_parameters& n) { return py::make_tuple(n.name, to_dict(n.parameters)); };
  const auto pairs = [&](std::vector<rt::named_parameters>& all) {
    py::list list;
    for (rt::named_parameters& one : all) list.append(pair(one));
    return list;
  };
  py::dict all;
  all["mechanism"] = pair(of.mechanism);
  all["brakes"] = to_dict(rt::any_parameters(of.brakes));
  all["brake_models"] = pairs(of.brake_models);
  all["law"] = pair(of.law);
  all["options"] = to_dict(rt::any_parameters(of.options));
  py::list walls;
  for (rt::wall_description& w : of.walls) {
    if (w.motion)
      refuse_value(path + ": a wall has a motion, expected walls that stay: others are in C++ only");
    walls.append(py::make_tuple(pairs(w.shapes), w.stiffness));
  }
  all["walls"] = walls;
  all["effects"] = pairs(of.effects);
  all["period"] = of.scene.period;
  all["has_force_sensor"] = of.has_force_sensor;
  all["remarks"] = of.remarks;
  return all;
}

}  // namespace
}  // namespace passive_haptics_python

PYBIND11_MODULE(_native, module) {
  using namespace passive_haptics_python;
  module.attr("__version__") = std::to_string(PASSIVE_HAPTICS_VERSION_MAJOR) + "." +
                               std::to_string(PASSIVE_HAPTICS_VERSION_MINOR) + "." +
                               std::to_string(PASSIVE_HAPTICS_VERSION_PATCH);
  module.def("status_text", [](int value) { return std::string(ph::to_string(ph::status(value))); });
  module.def("power_text", [](int value) { return std::string(ph::to_string(ph::power_class(value))); });
  module.def("display_text", [](int value) { return std::string(ph::to_string(ph::display_class(value))); });
  module.def("run_end_text", [](int value) { return std::string(ph::to_string(ph::run_end(value))); });
  module.def("read_device", &read_device);
  module.attr("catalogue") = py::capsule(&example::catalogue(), "passive_haptics::runtime::catalogue");
  for (const auto bind :
       {bind_named, bind_scenes, bind_devices, bind_simulations, bind_python_mechanism, bind_logs})
    bind(module);
}
