// Tables of parameters as dictionaries of Python.
#include "named.hpp"

#include <catalogue/catalogue.hpp>

#include <passive_haptics/core/parameter_text.hpp>
#include <passive_haptics/plant/wall_following.hpp>
#include <passive_haptics/runtime/device_file/device_description.hpp>
#include <passive_haptics/runtime/device_file/nearest_name.hpp>

#include <algorithm>

namespace passive_haptics_python {
namespace {

using rt::field;
using kind = rt::field::kind;

// The name of a parameter in Python: with a _ behind it if it is a keyword there.
std::string name_of(const field& f) {
  const std::string name = f.about.name;
  for (const char* word : {"as", "from", "in", "is", "lambda", "with"})
    if (name == word) return name + "_";
  return name;
}

// f(name, entries, dimension) of each list of the catalogue; 0: of any dimension.
template <class F>
void for_each_list(const F& f) {
  const rt::catalogue& all = example::catalogue();
  f("mechanism", all.mechanisms(), 0);
  f("law", all.laws(), 0);
  f("brake_model", all.brake_models(), 0);
  f("shape", all.shapes<2>(), 2);
  f("shape", all.shapes<3>(), 3);
  f("effect", all.effects<2>(), 2);
  f("effect", all.effects<3>(), 3);
}

rt::any_parameters defaults_of(const std::string& list, const std::string& name, int d) {
  if (list == "brakes" && (d < 1 || d > rt::max_joints))
    refuse_value("count = " + std::to_string(d) + ": expected 1 to " + std::to_string(rt::max_joints));
  if (list == "brakes") return rt::any_parameters(rt::brake_numbers(d));
  if (name == "following_hand") return rt::any_parameters(ph::following_hand_parameters<double>());
  if (name == "wall_following_parameters") return rt::any_parameters(ph::wall_following_parameters());
  if (name == "controller") return rt::any_parameters(rt::cycle_options());
  const rt::any_parameters* defaults = nullptr;
  for_each_list([&](const char* of, const auto& entries, int dimension) {
    if (list != of || (dimension != 0 && (d == 3) != (dimension == 3))) return;
    if (const auto* found = rt::find(entries, name)) defaults = &found->defaults;
  });
  if (defaults != nullptr) return *defaults;
  refuse_value(list + " = '" + name + "': expected a name of the catalogue of this dimension");
}

std::vector<std::string> names_of(const rt::field_list& fields) {
  std::vector<std::string> all;
  for (const field& f : fields) all.push_back(name_of(f));
  return all;
}

std::string joined(const std::vector<std::string>& words, const char* between = ", ") {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

void assign_all(const rt::field_list& fields, const py::dict& given, const std::string& owner,
                const std::string& prefix, bool broadcasts);

void assign_numbers(const field& f, py::handle x, const std::string& name, bool broadcasts) {
  if ((!PySequence_Check(x.ptr()) || PyUnicode_Check(x.ptr())) && (f.count() == 1 || broadcasts)) {
    std::fill_n(f.numbers(), f.count(), number_from(x, name));
  } else if (f.columns == 1) {
    std::ranges::copy(vector_from(x, name, f.rows), f.numbers());
  } else {
    const numbers_array rows = matrix_from(x, name, f.rows, f.columns);
    for (int i = 0; i < f.rows; ++i)
      for (int j = 0; j < f.columns; ++j) f.numbers()[i + j * f.rows] = rows.at(i, j);
  }
}

void assign(const field& f, py::handle x, const std::string& name, bool broadcasts) {
  switch (f.type) {
    case kind::numbers: return assign_numbers(f, x, name, broadcasts);
    case kind::whole: {
      if (f.rows > 1) refuse_type(name + " is a list of whole numbers, which is in C++ only");
      if (!f.set(f.at, whole_number_from(x, name)))
        refuse_value(name + " = " + shown(x) + ": expected a whole number >= 0");
      return;
    }
    case kind::truth:
      if (!PyBool_Check(x.ptr())) refuse_type(name + " = " + shown(x) + ": expected True or False");
      f.set(f.at, x.ptr() == Py_True);
      return;
    case kind::text:
      if (!PyUnicode_Check(x.ptr())) refuse_type(name + " = " + shown(x) + ": expected a text");
      f.text() = py::cast<std::string>(x);
      return;
    case kind::choice: {
      const auto words = ph::choices_of(f.about);
      const std::string expected = ": expected '" + joined({words.begin(), words.end()}, "' or '") + "'";
      if (!PyUnicode_Check(x.ptr())) refuse_type(name + " = " + shown(x) + expected);
      const auto found = std::ranges::find(words, py::cast<std::string>(x));
      if (found == words.end()) refuse_value(name + " = " + shown(x) + expected);
      f.set(f.at, static_cast<int>(found - words.begin()));
      return;
    }
    case kind::points: {
      const numbers_array rows = matrix_from(x, name, -1, f.rows);
      std::copy_n(rows.data(), rows.size(), f.resize(f.at, static_cast<std::size_t>(rows.shape(0))));
      return;
    }
    case kind::tables: {
      if (!PyList_Check(x.ptr()) && !PyTuple_Check(x.ptr()))
        refuse_type(name + " = " + shown(x) + ": expected a list of dicts");
      const auto list = py::reinterpret_borrow<py::sequence>(x);
      const std::vector<rt::field_list> tables =
          f.resize_tables == nullptr ? f.tables : f.resize_tables(f.at, list.size());
      require_length(name, list.size(), tables.size());
      for (std::size_t i = 0; i < tables.size(); ++i) {
        const std::string place = name + "[" + std::to_string(i) + "]";
        const py::object one = list[i];
        if (!PyDict_Check(one.ptr()))
          refuse_type(place + " = " + shown(one) + ": expected a dict of " + joined(names_of(tables[i])));
        assign_all(tables[i], one, place, place + ".", broadcasts);
      }
    }
  }
}

void assign_all(const rt::field_list& fields, const py::dict& given, const std::string& owner,
                const std::string& prefix, bool broadcasts) {
  const auto names = names_of(fields);
  for (const auto& [key, value] : given)
    if (const std::string called = py::str(key);
        !value.is_none() && std::ranges::find(names, called) == names.end())
      refuse_type(owner + " has no parameter '" + called + "': expected " +
                  (names.empty() ? "none" : joined(names)) + rt::did_you_mean(called, names));
  for (const field& f : fields)
    if (const std::string name = name_of(f); given.contains(name.c_str()) && !given[name.c_str()].is_none())
      assign(f, given[name.c_str()], prefix + name, broadcasts);
}

// Numbers column by column as a number, a list, or a list of rows.
py::object as_lists(const double* first, py::ssize_t rows, py::ssize_t columns) {
  if (rows == 1 && columns == 1) return py::float_(*first);
  if (columns == 1) return py::array_t<double>(rows, first).attr("tolist")();
  return py::array_t<double, py::array::f_style>({rows, columns}, first).attr("tolist")();
}

py::dict values_of(const rt::field_list& fields);
py::object value_of(const field& f) {
  switch (f.type) {
    case kind::numbers: return as_lists(f.numbers(), f.rows, f.columns);
    case kind::whole: return py::int_(f.get(f.at));
    case kind::truth: return py::bool_(f.get(f.at) != 0);
    case kind::text: return py::str(f.text());
    case kind::choice:
      return py::str(std::string(ph::choices_of(f.about).at(static_cast<std::size_t>(f.get(f.at)))));
    case kind::points: {
      const std::size_t count = f.size(f.at);
      return py::array_t<double>({py::ssize_t(count), py::ssize_t(f.rows)}, f.resize(f.at, count))
          .attr("tolist")();
    }
    case kind::tables: {
      py::list all;
      for (const rt::field_list& one : f.tables) all.append(values_of(one));
      return all;
    }
  }
  return py::none();
}
py::dict values_of(const rt::field_list& fields) {
  py::dict all;
  for (const field& f : fields) all[name_of(f).c_str()] = value_of(f);
  return all;
}

// True if the default of C++ is a value, so that none has to be given.
bool has_default(const field& f) {
  if (f.type == kind::points || f.resize_tables != nullptr) return false;
  if (f.type != kind::numbers) return true;
  const std::vector<double> numbers(f.numbers(), f.numbers() + f.count());
  return ph::check_value(f.about.name, numbers, f.about.unit, f.about.hard).empty();
}

// What help and signatures say of each field.
py::list described(const rt::field_list& fields) {
  static const char* const types[] = {"Numbers", "int", "bool", "choice", "str", "Rows", "tables"};
  py::list all;
  for (const field& f : fields) {
    py::dict one;
    one["name"] = name_of(f);
    one["unit"] = f.about.unit;
    one["type"] = f.type != kind::numbers ? types[static_cast<int>(f.type)]
                  : f.columns > 1         ? "Rows"
                  : f.rows > 1            ? "Numbers"
                                          : "float";
    one["choices"] = py::cast(std::string(f.about.choices));
    one["expected"] = ph::to_text(f.about.hard, f.type == kind::whole);
    one["default"] = has_default(f) ? value_of(f) : py::none();
    if (f.type == kind::tables)
      one["fields"] =
          described(f.resize_tables == nullptr ? f.tables.front() : f.resize_tables(f.at, 1).front());
    all.append(one);
  }
  return all;
}

// Names in each list, with their dimensions (2, 3, or both).
py::dict lists() {
  py::dict found;
  for_each_list([&](const char* list, const auto& entries, int dimension) {
    if (!found.contains(list)) found[list] = py::dict();
    for (const auto& e : entries) {
      const py::dict names = found[list];
      if (!names.contains(e.name.c_str())) names[e.name.c_str()] = py::list();
      if (dimension > 0) names[e.name.c_str()].attr("append")(dimension);
    }
  });
  found["table"] =
      py::dict(py::arg("wall_following_parameters") = py::list(), py::arg("following_hand") = py::list());
  py::list made_of_shapes;
  for (const auto& s : example::catalogue().shapes<2>())
    if (s.takes_shape) made_of_shapes.append(s.name);
  found["made_of_shapes"] = made_of_shapes;
  return found;
}

}  // namespace

named::named(const std::string& of, const std::string& called, int d, const py::dict& given)
    : list(of), name(called), dimension(d), table(defaults_of(of, called, d)) {
  assign_all(table.fields(), given, name, "", list == "brakes");
  if (const std::string error = table.error(); !error.empty()) refuse_value(error);
  table.for_each_suspicious([](const char*, const std::string& error) { warn(error); });
}

py::dict to_dict(rt::any_parameters table) { return values_of(table.fields()); }

void bind_named(py::module_& module) {
  py::class_<named>(module, "named")
      .def(py::init<const std::string&, const std::string&, int, const py::dict&>())
      .def("parameters", [](const named& n) { return to_dict(n.table); });
  module.def("lists", &lists);
  module.def("fields", [](const std::string& list, const std::string& name, int dimension) {
    return described(defaults_of(list, name, dimension).fields());
  });
}

}  // namespace passive_haptics_python
