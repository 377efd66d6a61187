// Numbers and arrays from Python.
#include "from_python.hpp"

#include <algorithm>
#include <cmath>

namespace passive_haptics_python {

std::string shown(py::handle x) {
  constexpr py::ssize_t max_length = 40;
  const py::object all = py::repr(x);
  std::string text = py::str(all[py::slice(0, max_length, 1)]);
  if (py::ssize_t(py::len(all)) > max_length) text += "...";
  std::ranges::replace(text, '\n', ' ');
  return text + " (" + Py_TYPE(x.ptr())->tp_name + ")";
}

namespace {

bool is_number(py::handle x) {
  if (PyBool_Check(x.ptr())) return false;
  if (PyFloat_Check(x.ptr()) || PyLong_Check(x.ptr())) return true;
  const py::module_ numpy = py::module_::import("numpy");
  return py::isinstance(x, numpy.attr("floating")) || py::isinstance(x, numpy.attr("integer"));
}

// A number with a name that only an error needs.
template <class Name>
double number_named(py::handle x, const Name& name) {
  if (!is_number(x)) refuse_type(name() + " = " + shown(x) + ": expected a number");
  const double value = PyFloat_AsDouble(x.ptr());
  if (!PyErr_Occurred()) return value;
  PyErr_Clear();
  refuse_value(name() + " = " + shown(x) + ": expected a number that a double can hold");
}

// A revolute joint turns less, and a slide is shorter.
void warn_of_degrees(double q) {
  constexpr double two_turns = 12.57, million = 1e6;
  if (std::abs(q) > two_turns && std::abs(q) < million)
    warn("q has " + std::string(py::str(py::float_(q))) +
         ", usually within two turns: degrees? numpy.radians(q) makes radians of them");
}

}  // namespace

double number_from(py::handle x, const std::string& name) {
  return number_named(x, [&] { return name; });
}

int whole_number_from(py::handle x, const std::string& name) {
  if (!is_number(x) || !PyIndex_Check(x.ptr()))
    refuse_type(name + " = " + shown(x) + ": expected a whole number");
  const long value = PyLong_AsLong(py::int_(py::reinterpret_borrow<py::object>(x)).ptr());
  if (PyErr_Occurred()) PyErr_Clear();
  else if (std::in_range<int>(value)) return static_cast<int>(value);
  refuse_value(name + " = " + shown(x) + ": expected a whole number of ordinary size");
}

py::array_t<double> array_from(py::handle x, const std::string& name, std::initializer_list<int> axes) {
  py::object given = py::reinterpret_borrow<py::object>(x);
  if (PyList_Check(x.ptr()) || PyTuple_Check(x.ptr())) {
    try {
      given = py::module_::import("numpy").attr("array")(x);
    } catch (const py::error_already_set&) {
      refuse_value(name + " = " + shown(x) + ": expected rows of equal length");
    }
  }
  if (!py::isinstance<py::array>(given))
    refuse_type(name + " = " + shown(x) + ": expected a list or an array of numbers");
  if (Py_TYPE(given.ptr()) != py::detail::npy_api::get().PyArray_Type_ &&
      !py::type::handle_of(given).is(py::module_::import("numpy").attr("memmap")))
    refuse_type(name + " is a " + Py_TYPE(given.ptr())->tp_name +
                ": expected a numpy.ndarray: make one of its values, as numpy.array(...) does");
  const auto array = py::reinterpret_borrow<py::array>(given);
  if (const char kind = array.dtype().kind(); kind != 'f' && kind != 'i' && kind != 'u')
    refuse_type(name + " has dtype " + std::string(py::str(array.dtype())) +
                ": expected real numbers: " + name + ".astype(float)");
  if (std::ranges::find(axes, int(array.ndim())) == axes.end())
    refuse_value(
        "shape of " + name + " = " + std::string(py::str(array.attr("shape"))) + ": expected " +
        std::array{"1 axis", "2 axes", "1 or 2 axes"}[std::size_t(axes.size() > 1 ? 2 : *axes.begin() - 1)]);
  constexpr int aligned = int(py::array::forcecast) | int(py::detail::npy_api::NPY_ARRAY_ALIGNED_);
  return py::array_t<double, aligned>(array);
}

py::array_t<double> matrix_from(py::handle x, const std::string& name, int rows, int columns) {
  py::array_t<double> all = array_from(x, name, {2});
  if ((rows >= 0 && all.shape(0) != rows) || (columns >= 0 && all.shape(1) != columns))
    refuse_value("shape of " + name + " = " + std::string(py::str(all.attr("shape"))) + ": expected (" +
                 (rows < 0 ? "N" : std::to_string(rows)) + ", " + std::to_string(columns) + ")");
  const auto q = all.unchecked<2>();
  double largest = 0;
  for (py::ssize_t j = 0; name == "q" && j < columns; ++j)
    for (py::ssize_t i = 0; i < q.shape(0); ++i)
      if (const double angle = std::abs(q(i, j)); angle > largest) largest = angle;
  warn_of_degrees(largest);
  return all;
}

void require_length(const std::string& name, std::size_t found, std::size_t expected) {
  if (found != expected)
    refuse_value("length of " + name + " = " + std::to_string(found) + ": expected " +
                 std::to_string(expected));
}

std::vector<double> vector_from(py::handle x, const std::string& name, int size) {
  std::vector<double> all;
  if (PyList_Check(x.ptr()) || PyTuple_Check(x.ptr())) {  // a few numbers: without NumPy, which takes longer
    for (const py::handle each : py::reinterpret_borrow<py::sequence>(x))
      all.push_back(number_named(each, [&] { return name + "[" + std::to_string(all.size()) + "]"; }));
  } else {
    const numbers_array array = array_from(x, name, {1});
    all.assign(array.data(), array.data() + array.size());
  }
  if (size >= 0) require_length(name, all.size(), std::size_t(size));
  if (name == "q" && !all.empty())
    warn_of_degrees(std::ranges::max(all, {}, [](double angle) { return std::abs(angle); }));
  return all;
}

rows_of::rows_of(py::handle x, const std::string& name, int width)
    : array_(array_from(x, name, {1, 2})), width_(width), is_one_(array_.ndim() == 1) {
  if (is_one_) require_length(name, std::size_t(array_.size()), std::size_t(width));
  else matrix_from(array_, name, -1, width);
}

rows_of::rows_of(py::handle x, const std::string& name, int width, const rows_of& q)
    : rows_of(x, name, width) {
  if (!is_one_ && size() != q.size())
    refuse_value("number of rows of " + name + " = " + std::to_string(size()) + ": expected " +
                 std::to_string(q.size()) + ", as q has");
}

}  // namespace passive_haptics_python
