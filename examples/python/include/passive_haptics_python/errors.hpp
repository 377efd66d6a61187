/// @file
/// Exceptions about what a Python user passed: the value, what was expected and what to do.
#pragma once

#include <pybind11/pybind11.h>

#include <string>

namespace passive_haptics_python {

namespace py = pybind11;

/// Ends in a TypeError with this text.
[[noreturn]] inline void refuse_type(const std::string& text) {
  throw py::type_error("passive_haptics: " + text);
}

/// Ends in a ValueError with this text.
[[noreturn]] inline void refuse_value(const std::string& text) {
  throw py::value_error("passive_haptics: " + text);
}

/// A value and its type for a message: "'abc' (str)", at most 40 characters of it.
inline std::string shown(py::handle x) {
  constexpr py::ssize_t max_length = 40;
  const py::object all = py::repr(x);
  std::string text = py::str(all[py::slice(0, max_length, 1)]);
  if (py::ssize_t(py::len(all)) > max_length) text += "...";
  for (char& c : text)
    if (c == '\n') c = ' ';
  return text + " (" + Py_TYPE(x.ptr())->tp_name + ")";
}

/// x as a T, a class that is bound to Python; else a TypeError that says what was expected.
template <class T>
T& expect(py::handle x, const char* name, const char* expected) {
  if (!py::isinstance<T>(x)) refuse_type(std::string(name) + " = " + shown(x) + ", expected " + expected);
  return py::cast<T&>(x);
}

}  // namespace passive_haptics_python
