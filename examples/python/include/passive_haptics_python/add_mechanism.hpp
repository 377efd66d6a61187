/// @file
/// A mechanism of your own in C++, for Python: a module of yours adds it to the catalogue of the package.
#pragma once

#include <passive_haptics/runtime/catalogue.hpp>

#include <pybind11/pybind11.h>

namespace passive_haptics_python {

/// Adds mechanism M, made of parameters P or of none, to the installed package, and its class to this module:
///
///     PYBIND11_MODULE(mine, module) { passive_haptics_python::add_mechanism<my_arm>(module, "my_arm"); }
///
/// It has the controllers that the package has for its kind (runtime/mechanism_of_kind.hpp). Throws
/// pybind11's error if the package is not installed.
template <passive_haptics::DifferentiableMechanism M,
          passive_haptics::Parameters P = passive_haptics::runtime::no_parameters>
void add_mechanism(pybind11::module_& module, const char* name, const char* about = "A mechanism.") {
  namespace py = pybind11;
  using passive_haptics::runtime::catalogue;
  const py::capsule all = py::module_::import("passive_haptics._native").attr("catalogue");
  all.get_pointer<catalogue>()->add_mechanism<M, P>(name);
  module.attr(name) = py::module_::import("passive_haptics.classes")
                          .attr("added_mechanism")(name, about, module.attr("__name__"));
}

}  // namespace passive_haptics_python
