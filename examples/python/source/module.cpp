// The module _native of the package passive_haptics: what its Python is made of. Its classes are not for
// users.
#include "devices.hpp"

#include <catalogue/catalogue.hpp>
#include <log/log_columns.hpp>

#include <passive_haptics/core/version.hpp>
#include <passive_haptics/runtime/device_file/device_text.hpp>
#include <passive_haptics/runtime/device_file/read_device.hpp>

#include <pybind11/stl.h>

#include <array>
#include <fstream>
#include <stdexcept>
#include <string>

namespace passive_haptics_python {
namespace {

// A device file as names and dictionaries.
py::dict read_device(const std::string& path) {
  const rt::toml_section file = rt::toml_section::file(path);
  rt::device_description of = rt::read_device(file, example::catalogue());
  const auto pair = [](rt::named_parameters& n) { return py::make_tuple(n.name, to_dict(n.parameters)); };
  py::list models;
  for (rt::named_parameters& one : of.brake_models) models.append(pair(one));
  py::dict all;
  all["mechanism"] = pair(of.mechanism);
  all["brakes"] = to_dict(rt::any_parameters(of.brakes));
  all["brake_models"] = models;
  all["law"] = pair(of.law);
  all["options"] = to_dict(rt::any_parameters(of.options));
  all["has_force_sensor"] = of.has_force_sensor;
  all["remarks"] = of.remarks;
  all["text"] = rt::device_text(of);
  return all;
}

scene scene_of_device(const std::string& text) {
  const rt::toml_section file = rt::toml_section::text("text of a scene_of_device", text);
  return {rt::read_device(file, example::catalogue()).make_scene(example::catalogue())};
}

// The parameters of a chain of a URDF, and the remarks.
py::tuple chain_from_urdf(const std::string& path, const std::string& base, const std::string& tip,
                          const std::array<double, 3>& tool, bool balanced) {
  const rt::urdf_reader& reader = example::catalogue().urdf_reader();
  if (!reader)
    throw std::runtime_error(
        "passive_haptics: chain_from_urdf: expected a package that is built with urdfdom; install Debian's "
        "liburdfdom-dev, then build the package with PASSIVE_HAPTICS_URDF=ON in the environment");
  const rt::urdf_mechanism made = reader({path, base, tip, {tool[0], tool[1], tool[2]}, balanced}, "");
  return py::make_tuple(to_dict(made.parameters), made.remarks);
}

// Bytes that are not UTF-8 stay what they are, as in the names of files.
py::object text_from(const std::string& bytes) {
  return py::reinterpret_steal<py::object>(
      PyUnicode_DecodeUTF8(bytes.data(), std::ssize(bytes), "surrogateescape"));
}

// Arrays of numbers or lists of words, and units, by the names of the columns.
py::tuple read_log(const std::string& path) {
  std::ifstream file(path);
  py::dict values, units;
  try {
    example::log_reader log(file, path);
    for (const example::log_column& column : example::columns_of(log, let_others_run)) {
      py::list words;
      for (const std::string& word : column.words) words.append(text_from(word));
      const py::object name = text_from(column.name);
      values[name] = column.is_words() ? py::object(words) : array_of(column.numbers);
      units[name] = text_from(column.unit);
    }
  } catch (const example::log_error& error) {
    refuse_value(error.what());
  }
  return py::make_tuple(values, units);
}

}  // namespace
}  // namespace passive_haptics_python

PYBIND11_MODULE(_native, module) {
  using namespace passive_haptics_python;
  module.attr("__version__") = std::to_string(PASSIVE_HAPTICS_VERSION_MAJOR) + "." +
                               std::to_string(PASSIVE_HAPTICS_VERSION_MINOR) + "." +
                               std::to_string(PASSIVE_HAPTICS_VERSION_PATCH);
  module.def("text_of", [](const std::string& name, int value) {
    return std::string(name == "status"          ? ph::to_string(ph::status(value))
                       : name == "power_class"   ? ph::to_string(ph::power_class(value))
                       : name == "display_class" ? ph::to_string(ph::display_class(value))
                                                 : ph::to_string(ph::run_end(value)));
  });
  module.def("read_device", &read_device);
  module.def("scene_of_device", &scene_of_device);
  module.def("chain_from_urdf", &chain_from_urdf);
  module.attr("catalogue") = py::capsule(&example::catalogue(), "passive_haptics::runtime::catalogue");
  module.def("read_log", &read_log);
  for (const auto bind : {bind_named, bind_scenes, bind_devices, bind_simulations, bind_python_mechanism})
    bind(module);
}
