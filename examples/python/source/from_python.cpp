// Numbers and arrays from Python.
#include "from_python.hpp"

#include <algorithm>

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

}  // namespace

double number_from(py::handle x, const std::string& name) {
  return number_named(x, [&] { return name; });
}

int whole_number_from(py::handle x, const std::string& name) {
  if (!is_number(x) || PyFloat_Check(x.ptr()))
    refuse_type(name + " = " + shown(x) + ": expected a whole number");
  const long value = PyLong_AsLong(py::int_(py::reinterpret_borrow<py::object>(x)).ptr());
  if (PyErr_Occurred()) PyErr_Clear();
  else if (std::in_range<int>(value)) return static_cast<int>(value);
  refuse_value(name + " = " + shown(x) + ": expected a whole number of ordinary size");
}

numbers_array array_from(py::handle x, const std::string& name, std::initializer_list<int> axes) {
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
    refuse_value("shape of " + name + " = " + std::string(py::str(array.attr("shape"))) + ": expected " +
                 std::to_string(*axes.begin()) +
                 (axes.size() > 1      ? " or 2 axes"
                  : *axes.begin() == 1 ? " axis"
                                       : " axes"));
  return numbers_array(array);
}

numbers_array matrix_from(py::handle x, const std::string& name, int rows, int columns) {
  numbers_array all = array_from(x, name, {2});
  if ((rows >= 0 && all.shape(0) != rows) || (columns >= 0 && all.shape(1) != columns))
    refuse_value("shape of " + name + " = " + std::string(py::str(all.attr("shape"))) + ": expected (" +
                 (rows < 0 ? "N" : std::to_string(rows)) + ", " + std::to_string(columns) + ")");
  return all;
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
  if (size >= 0 && std::ssize(all) != size)
    refuse_value("length of " + name + " = " + std::to_string(all.size()) + ": expected " +
                 std::to_string(size));
  return all;
}

rows_of::rows_of(py::handle x, const std::string& name, int width)
    : array_(array_from(x, name, {1, 2})), width_(width), is_one_(array_.ndim() == 1) {
  const py::ssize_t found = array_.shape(array_.ndim() - 1);
  if (found == width) return;
  if (is_one_)
    refuse_value("length of " + name + " = " + std::to_string(found) + ": expected " + std::to_string(width));
  refuse_value("shape of " + name + " = " + std::string(py::str(array_.attr("shape"))) + ": expected (N, " +
               std::to_string(width) + ")");
}

rows_of::rows_of(py::handle x, const std::string& name, int width, const rows_of& q)
    : rows_of(x, name, width) {
  if (!is_one_ && size() != q.size())
    refuse_value("number of rows of " + name + " = " + std::to_string(size()) + ": expected " +
                 std::to_string(q.size()) + ", as q has");
}

}  // namespace passive_haptics_python
