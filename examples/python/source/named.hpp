/// @file
/// Values of tables of parameters, of the catalogue and others, as dictionaries of Python.
#pragma once

#include "from_python.hpp"

#include <passive_haptics/runtime/any_parameters.hpp>

#include <string>

namespace passive_haptics_python {

namespace rt = passive_haptics::runtime;

/// Parameters with their name in a list: "mechanism", "law", "shape", "effect" or "brake_model" of the
/// catalogue, "brakes" by their number, or "table" of another struct.
struct named {
  std::string list;          ///< The list.
  std::string name;          ///< In the list.
  int dimension = 0;         ///< 2 or 3 of a shape or an effect.
  rt::any_parameters table;  ///< The values.

  /// Those that are not None over the default values. A ValueError if there is no such name; a TypeError or
  /// ValueError with the name of a parameter that is wrong; a warning about a value that no device has.
  named(const std::string& of, const std::string& called, int d, const py::dict& given);
};

/// All parameters.
py::dict to_dict(rt::any_parameters table);
/// Binds the lists and their values.
void bind_named(py::module_& module);

}  // namespace passive_haptics_python
