/// @file
/// Numbers and short vectors from Python.
#pragma once

#include <passive_haptics_python/errors.hpp>

#include <passive_haptics/core/matrix.hpp>

#include <pybind11/numpy.h>

#include <string>

namespace passive_haptics_python {

namespace ph = passive_haptics;

/// Whether x is a real number of Python or NumPy: no bool, no text, no array.
inline bool is_number(py::handle x) {
  PyObject* const object = x.ptr();
  if (PyBool_Check(object)) return false;
  if (PyFloat_Check(object) || PyLong_Check(object)) return true;
  const py::module_ numpy = py::module_::import("numpy");
  return py::isinstance(x, numpy.attr("floating")) || py::isinstance(x, numpy.attr("integer"));
}

/// x as a double; else a TypeError.
inline double number_from(py::handle x, const std::string& name) {
  if (!is_number(x)) refuse_type(name + " = " + shown(x) + ", expected a number");
  const double value = PyFloat_AsDouble(x.ptr());
  if (!PyErr_Occurred()) return value;
  PyErr_Clear();
  refuse_value(name + " = " + shown(x) + ", expected a number that a double can hold");
}

/// x as a whole number; else a TypeError.
inline long whole_number_from(py::handle x, const std::string& name) {
  if (!is_number(x) || PyFloat_Check(x.ptr()))
    refuse_type(name + " = " + shown(x) + ", expected a whole number");
  const long value = PyLong_AsLong(x.ptr());
  if (!PyErr_Occurred()) return value;
  PyErr_Clear();
  refuse_value(name + " = " + shown(x) + ", expected a whole number of ordinary size");
}

/// x as an array of NumPy. An array of a class that is made of it (masked, matrix) may mean something else
/// and is refused; of memory in a file it is taken.
inline py::array plain_array(py::handle x, const std::string& name) {
  const py::module_ numpy = py::module_::import("numpy");
  const py::handle type = py::type::handle_of(x);
  if (!type.is(numpy.attr("ndarray")) && !type.is(numpy.attr("memmap")))
    refuse_type(name + " is a " + Py_TYPE(x.ptr())->tp_name +
                ", expected a numpy.ndarray: make one of its values, as numpy.array(...) does");
  return py::reinterpret_borrow<py::array>(x);
}

/// The kind of an array's numbers, as a text for a message.
inline std::string dtype_of(const py::array& x) { return py::str(x.dtype()); }

/// x, a list, a tuple or a one-dimensional array of real numbers, as a vector of N numbers; of any number of
/// them where N is Eigen::Dynamic.
template <int N>
ph::vector<double, N> vector_from(py::handle x, const std::string& name) {
  ph::vector<double, N> v;
  const auto check_size = [&](py::ssize_t size) {
    if (N == Eigen::Dynamic) v.resize(size);
    else if (size != N)
      refuse_value("length of " + name + " = " + std::to_string(size) + ", expected " + std::to_string(N));
  };
  if (PyList_Check(x.ptr()) || PyTuple_Check(x.ptr())) {
    const auto list = py::reinterpret_borrow<py::sequence>(x);
    check_size(py::ssize_t(list.size()));
    for (int i = 0; i < v.size(); ++i)
      v[i] = number_from(py::object(list[std::size_t(i)]), name + "[" + std::to_string(i) + "]");
    return v;
  }
  if (!py::isinstance<py::array>(x))
    refuse_type(name + " = " + shown(x) + ", expected a list or an array of numbers");
  const py::array array = plain_array(x, name);
  const char kind = array.dtype().kind();
  if (kind != 'f' && kind != 'i' && kind != 'u')
    refuse_type(name + " has dtype " + dtype_of(array) + ", expected real numbers: " + name +
                ".astype(float)");
  if (array.ndim() != 1)
    refuse_value(name + " has " + std::to_string(array.ndim()) + " axes, expected one: " + name + ".ravel()");
  check_size(array.shape(0));
  const py::array_t<double, py::array::forcecast> numbers(array);
  for (int i = 0; i < v.size(); ++i) v[i] = numbers.at(i);
  return v;
}

/// The length, 2 or 3, of the first sequence among these parameters of `name`; 0 if there is none. A
/// ValueError says what was expected of another length.
inline int first_length(const py::dict& given, const std::string& name, const std::string& expected) {
  for (const auto& [key, value] : given) {
    if (!PySequence_Check(value.ptr()) || PyUnicode_Check(value.ptr())) continue;
    const py::ssize_t size = PySequence_Size(value.ptr());
    if (size < 0) throw py::error_already_set();
    if (size != 2 && size != 3)
      refuse_value("length of " + std::string(py::str(key)) + " of " + name + " = " + std::to_string(size) +
                   ", expected " + expected);
    return int(size);
  }
  return 0;
}

}  // namespace passive_haptics_python
