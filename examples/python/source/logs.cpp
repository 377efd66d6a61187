// Logs (examples/log), for logs.py of the package.
#include "devices.hpp"

#include <log/log_columns.hpp>

#include <fstream>

namespace passive_haptics_python {
namespace {

// Bytes that are not UTF-8 stay what they are, as in the names of files.
py::object text_from(const std::string& bytes) {
  PyObject* const text = PyUnicode_DecodeUTF8(bytes.data(), py::ssize_t(bytes.size()), "surrogateescape");
  if (text == nullptr) throw py::error_already_set();
  return py::reinterpret_steal<py::object>(text);
}

// Arrays of numbers or lists of words, and units, by the names of the columns. `shown`: in errors.
py::tuple read(const py::bytes& path, const std::string& shown) {
  std::ifstream file{std::string(path)};
  py::dict values, units;
  try {
    example::log_reader log(file, shown);
    for (const example::log_column& column : example::columns_of(log, let_others_run)) {
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

void bind_logs(py::module_& module) { module.def("read_log", &read); }

}  // namespace passive_haptics_python
