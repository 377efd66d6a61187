/// @file
/// What Python users expect of each class of values: keywords, repr, equality, pickling, copies.
#pragma once

#include <passive_haptics_python/parameter_documentation.hpp>

#include <string>
#include <utility>
#include <vector>

namespace passive_haptics_python {

/// A value made of a table's parameters. Kind: the base class that Python users see, such as `law`.
template <class Kind, ph::Parameters P>
struct table_value : Kind {
  P table = {};  ///< The parameters.

  /// The defaults.
  table_value() = default;
  /// Of these parameters.
  explicit table_value(const P& p) : table(p) {}

  /// The names of the parameters, in the order of the table.
  static std::vector<std::string> names() { return member_names<P>(); }
  /// Of a dictionary; a ValueError with the library's own text where a parameter is not valid.
  static table_value made(const py::dict& given, const std::string& name) {
    P p{};
    assign_members(p, given, name);
    ph::require_no_error(ph::validate(p));
    return table_value(p);
  }
  /// All parameters.
  py::dict parameters() const { return to_dict(table); }
  /// Those that are not the defaults.
  py::dict changed() const { return changed_members(table, P{}); }
};

/// Arguments by position and by keyword as one dictionary.
inline py::dict named(const py::args& args, const py::kwargs& kwargs, const std::vector<std::string>& names,
                      const std::string& owner) {
  if (args.size() > names.size())
    refuse_type(owner + " takes " + std::to_string(names.size()) + " parameters, " +
                std::to_string(args.size()) + " were given");
  py::dict all;
  for (std::size_t i = 0; i < args.size(); ++i) all[names[i].c_str()] = args[i];
  for (const auto& [key, value] : kwargs) {
    if (all.contains(key)) refuse_type(std::string(py::str(key)) + " of " + owner + " was given twice");
    all[key] = value;
  }
  return all;
}

/// "name(key=value, ...)".
inline std::string call_text(const std::string& name, const py::dict& arguments) {
  std::string text;
  for (const auto& [key, value] : arguments)
    text += (text.empty() ? "" : ", ") + std::string(py::str(key)) + "=" + std::string(py::repr(value));
  return name + "(" + text + ")";
}

/// Binds X(...), parameters, ==, repr and pickling. X: names(), made(dict, name), parameters() and changed(),
/// as of a table_value.
template <class X, class... Options>
void add_value_protocol(py::class_<X, Options...>& bound, const std::string& name) {
  bound.def(py::init([name](const py::args& args, const py::kwargs& kwargs) {
    return X::made(named(args, kwargs, X::names(), name), name);
  }));
  bound.def_property_readonly("parameters", &X::parameters,
                              "dict[str, Any]: A copy of all parameters, by their names.");
  bound.def("__repr__", [name](const X& x) { return call_text(name, x.changed()); });
  bound.def("__eq__", [](const X& x, const py::object& other) -> py::object {
    if (!py::isinstance<X>(other)) return py::reinterpret_borrow<py::object>(Py_NotImplemented);
    return py::bool_(x.parameters().equal(py::cast<const X&>(other).parameters()));
  });
  bound.attr("__hash__") = py::none();
  bound.def(py::pickle([](const X& x) { return x.parameters(); },
                       [name](const py::dict& state) { return X::made(state, name); }));
}

}  // namespace passive_haptics_python
