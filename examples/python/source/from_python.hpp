/// @file
/// Numbers and arrays from Python, and exceptions about what a user passed: the value, what was expected and
/// what to do.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <cstddef>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

namespace passive_haptics {}

namespace passive_haptics_python {

namespace py = pybind11;
namespace ph = passive_haptics;

/// Ends in a TypeError with this text.
[[noreturn]] inline void refuse_type(const std::string& text) {
  throw py::type_error("passive_haptics: " + text);
}
/// Ends in a ValueError with this text.
[[noreturn]] inline void refuse_value(const std::string& text) {
  throw py::value_error("passive_haptics: " + text);
}

/// A warning at the line of the user, if there is a text.
inline void warn(const std::string& text) {
  py::module_::import("passive_haptics.values").attr("warn")(text);
}

/// A value and its type for a message: "'abc' (str)", at most 40 characters of it.
std::string shown(py::handle x);

/// x as a double; else a TypeError. Neither a bool, nor a text, nor an array is a number.
double number_from(py::handle x, const std::string& name);
/// x as a whole number; else a TypeError.
int whole_number_from(py::handle x, const std::string& name);

/// Numbers one row after the other.
using numbers_array = py::array_t<double, py::array::c_style | py::array::forcecast>;
/// x, a list, a tuple or an array of real numbers, as an array of float64 with one of these numbers of axes;
/// else a TypeError or ValueError. An array of a class that is derived from numpy.ndarray (masked, matrix) is
/// rejected, as it may mean something else.
py::array_t<double> array_from(py::handle x, const std::string& name, std::initializer_list<int> axes);
/// x as rows of numbers; -1: any number of them. Warns of joint positions, named "q", in degrees.
py::array_t<double> matrix_from(py::handle x, const std::string& name, int rows, int columns);

/// A ValueError if a list of this name has another length.
void require_length(const std::string& name, std::size_t found, std::size_t expected);
/// x as a vector of `size` numbers, of any number where size is -1. Warns as matrix_from().
std::vector<double> vector_from(py::handle x, const std::string& name, int size = -1);

/// Rows of numbers: N of them, or one that stands for a single pose.
class rows_of {
 public:
  /// Of an array with `width` numbers in each row, or of one row.
  rows_of(py::handle x, const std::string& name, int width);
  /// As many as q has, or one for all.
  rows_of(py::handle x, const std::string& name, int width, const rows_of& q);
  bool is_one() const { return is_one_; }  ///< A single row without an axis of its own.
  py::ssize_t size() const { return is_one_ ? 1 : array_.shape(0); }  ///< N
  std::span<const double> operator[](py::ssize_t k) const {           ///< Row k; the only row for each k.
    return {array_.data() + (is_one_ ? 0 : k) * width_, static_cast<std::size_t>(width_)};
  }

 private:
  numbers_array array_;
  py::ssize_t width_;
  bool is_one_ = false;
};

/// An array of a row of this shape for each of rows N, without the first axis where N is a single row.
template <class T = double>
py::array_t<T> results_for(const rows_of& rows, std::vector<py::ssize_t> shape) {
  if (!rows.is_one()) shape.insert(shape.begin(), rows.size());
  return py::array_t<T>(shape);
}

/// Numbers as an array.
template <class V>
py::array_t<double> array_of(const V& v) {
  return py::array_t<double>(static_cast<py::ssize_t>(v.size()), v.data());
}

/// The value of an enumeration as the IntEnum of the package.
template <class E>
py::object enumerated(const char* name, E value) {
  return py::module_::import("passive_haptics.results").attr(name)(static_cast<int>(value));
}

/// In row k of many, now and then lets other threads of Python run, and throws KeyboardInterrupt after
/// Ctrl-C.
inline void let_others_run(py::ssize_t k = 0) {
  constexpr py::ssize_t rows_between = 1 << 8;
  if (k % rows_between != 0) return;
  {
    const py::gil_scoped_release unlocked;
  }
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
}

}  // namespace passive_haptics_python
