// Logs (examples/log), for logs.py of the package.
#include "devices.hpp"

#include <log/known_columns.hpp>
#include <log/log_columns.hpp>

#include <fstream>

namespace passive_haptics_python {
namespace {

using example::log_column;

[[noreturn]] void refuse_log(const example::log_error& error) { refuse_value(error.what()); }

// Bytes that are not UTF-8 stay what they are, as in the names of files.
py::object text_from(const std::string& bytes) {
  PyObject* const text = PyUnicode_DecodeUTF8(bytes.data(), py::ssize_t(bytes.size()), "surrogateescape");
  if (text == nullptr) throw py::error_already_set();
  return py::reinterpret_steal<py::object>(text);
}
std::string bytes_of(py::handle text) {
  PyObject* const bytes = PyUnicode_AsEncodedString(text.ptr(), "utf-8", "surrogateescape");
  if (bytes == nullptr) throw py::error_already_set();
  return py::reinterpret_steal<py::bytes>(bytes);
}

py::object values_of(const log_column& column) {
  if (!column.is_words()) return py::array(py::ssize_t(column.size()), column.numbers.data());
  py::list words;
  for (const std::string& word : column.words) words.append(text_from(word));
  return words;
}

// Columns as Python has them: names, units, and arrays of float64 or lists of words.
std::vector<log_column> columns_from(const py::list& names, const py::list& units, const py::list& values) {
  std::vector<log_column> columns;
  for (std::size_t i = 0; i < names.size(); ++i) {
    log_column column{bytes_of(names[i]), bytes_of(units[i]), {}, {}};
    if (column.is_words()) {
      for (const py::handle word : py::list(values[i])) column.words.push_back(bytes_of(word));
    } else {
      const py::array_t<double> numbers(values[i]);
      for (py::ssize_t k = 0; k < numbers.size(); ++k) column.numbers.push_back(numbers.at(k));
    }
    columns.push_back(std::move(column));
  }
  return columns;
}

py::tuple read(const py::bytes& path, py::handle name) {
  std::ifstream file{std::string(path)};
  std::vector<log_column> columns;
  try {
    example::log_reader log(file, bytes_of(name));
    columns = example::columns_of(log, let_others_run);
  } catch (const example::log_error& error) {
    refuse_log(error);
  }
  py::list names, units, values;
  for (const log_column& column : columns) {
    names.append(text_from(column.name));
    units.append(text_from(column.unit));
    values.append(values_of(column));
  }
  return py::make_tuple(names, units, values);
}

void check(const py::bytes& path, py::handle name, const py::list& names, const py::list& units,
           const py::list& values) {
  std::ifstream file{std::string(path)};
  try {
    example::log_reader log(file, bytes_of(name));
    example::require_equal(log, columns_from(names, units, values), let_others_run);
  } catch (const example::log_error& error) {
    refuse_log(error);
  }
}

py::bytes text_of(const py::list& names, const py::list& units, const py::list& values, bool with_header) {
  return example::log_text(columns_from(names, units, values), with_header);
}

py::object unit_of(py::handle name) {
  const auto* known = example::find_known(bytes_of(name));
  return known == nullptr ? py::none() : py::object(text_from(std::string(known->units.front())));
}
bool is_along_axes(py::handle name) {
  const std::string part = bytes_of(name);
  for (const auto& known : example::known_columns())
    if (known.name == part) return known.parts == example::column_parts::axes;
  return false;
}

}  // namespace

void bind_logs(py::module_& module) {
  module.def("read_log", &read);
  module.def("log_text", &text_of);
  module.def("check_log", &check);
  module.def("unit_of_column", &unit_of);
  module.def("is_along_axes", &is_along_axes);
}

}  // namespace passive_haptics_python
