// The module _native of the package passive_haptics: what its Python is made of. Its classes are not for
// users.
#include "devices.hpp"

#include <catalogue/catalogue.hpp>
#include <driver_keys.hpp>
#include <log/log_columns.hpp>

#include <passive_haptics/core/version.hpp>
#include <passive_haptics/runtime/device_file/device_text.hpp>
#include <passive_haptics/runtime/device_file/read_device.hpp>

#include <pybind11/stl.h>

#include <fstream>
#include <stdexcept>
#include <string>

namespace passive_haptics_python {
namespace {

rt::device_description description_of(rt::toml_section file) {
  rt::device_description of = rt::read_device(file, example::catalogue());
  example::finish_without_driver(file);
  return of;
}

// The parts of a device of a file: names, dictionaries and the text of its scene.
py::tuple read_device(const std::string& path) {
  rt::device_description of = description_of(rt::toml_section::file(path));
  warn(of.remarks);
  const auto pair = [](rt::named_parameters& n) { return py::make_tuple(n.name, to_dict(n.parameters)); };
  py::list models;
  for (rt::named_parameters& one : of.brake_models) models.append(pair(one));
  return py::make_tuple(pair(of.mechanism), to_dict(rt::any_parameters(of.brakes)), pair(of.law), models,
                        rt::device_text(of), of.has_force_sensor, to_dict(rt::any_parameters(of.options)),
                        of.remarks);
}

scene scene_of_device(const std::string& text) {
  return {description_of(rt::toml_section::text("text of a scene_of_device", text))
              .make_scene(example::catalogue())};
}

// The parameters of a chain of a URDF.
py::dict chain_from_urdf(const std::string& path, const std::string& base, const std::string& tip,
                         py::handle tool, bool balanced) {
  const rt::urdf_reader& reader = example::catalogue().urdf_reader();
  if (!reader)
    throw std::runtime_error(
        "passive_haptics: chain_from_urdf: expected a package that is built with urdfdom; install Debian's "
        "liburdfdom-dev, then build the package with PASSIVE_HAPTICS_URDF=ON in the environment");
  const std::vector<double> x = vector_from(tool, "tool", 3);
  const rt::urdf_mechanism made = reader({path, base, tip, {x[0], x[1], x[2]}, balanced}, "");
  warn(made.remarks);
  return to_dict(made.parameters);
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
    for (const example::log_column& column : example::columns_of(log, [] { let_others_run(); })) {
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
  module.attr("__module__") = "passive_haptics";  // in the names of its classes
  module.attr("__version__") = std::to_string(PASSIVE_HAPTICS_VERSION_MAJOR) + "." +
                               std::to_string(PASSIVE_HAPTICS_VERSION_MINOR) + "." +
                               std::to_string(PASSIVE_HAPTICS_VERSION_PATCH);
  module.def("text_of", [](const std::string& name, int value) {
    return std::string(name == "status"          ? ph::to_string(ph::status(value))
                       : name == "power_class"   ? ph::to_string(ph::power_class(value))
                       : name == "display_class" ? ph::to_string(ph::display_class(value))
                                                 : ph::to_string(ph::run_end(value)));
  });
  module.def("number", &number_from);
  module.def("whole_number", &whole_number_from);
  module.def("vector", &vector_from);
  module.def("read_device", &read_device);
  module.def("scene_of_device", &scene_of_device);
  module.def("chain_from_urdf", &chain_from_urdf);
  module.attr("catalogue") = py::capsule(&example::catalogue(), "passive_haptics::runtime::catalogue");
  module.def("read_log", &read_log);
  for (const auto bind : {bind_named, bind_scenes, bind_devices, bind_simulations, bind_python_mechanism})
    bind(module);
}
