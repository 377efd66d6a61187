// Tables of parameters as dictionaries of Python.
#include "named.hpp"

#include <catalogue/catalogue.hpp>

#include <passive_haptics/core/parameter_text.hpp>
#include <passive_haptics/plant/wall_following.hpp>
#include <passive_haptics/runtime/device_file/device_description.hpp>
#include <passive_haptics/runtime/device_file/nearest_name.hpp>

#include <algorithm>
#include <limits>

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

template <class Entries>
const rt::any_parameters* defaults_in(const Entries& all, const std::string& name) {
  const auto* found = rt::find(all, name);
  return found == nullptr ? nullptr : &found->defaults;
}

rt::any_parameters defaults_of(const std::string& list, const std::string& name, int d) {
  const rt::catalogue& all = example::catalogue();
  const rt::any_parameters* found = nullptr;
  if (list == "mechanism") found = defaults_in(all.mechanisms(), name);
  else if (list == "law") found = defaults_in(all.laws(), name);
  else if (list == "brake_model") found = defaults_in(all.brake_models(), name);
  else if (list == "shape")
    found = d == 2 ? defaults_in(all.shapes<2>(), name) : defaults_in(all.shapes<3>(), name);
  else if (list == "effect")
    found = d == 2 ? defaults_in(all.effects<2>(), name) : defaults_in(all.effects<3>(), name);
  else if (list == "brakes") return rt::any_parameters(rt::brake_numbers(d));
  else if (name == "following_hand") return rt::any_parameters(ph::following_hand_parameters<double>());
  else if (name == "wall_following_parameters") return rt::any_parameters(ph::wall_following_parameters());
  else if (name == "controller") return rt::any_parameters(rt::cycle_options());
  if (found != nullptr) return *found;
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
    const py::array_t<double> rows = array_from(x, name, {2});
    if (rows.shape(0) != f.rows || rows.shape(1) != f.columns)
      refuse_value("shape of " + name + " = " + std::string(py::str(rows.attr("shape"))) + ": expected (" +
                   std::to_string(f.rows) + ", " + std::to_string(f.columns) + ")");
    const auto at = rows.unchecked<2>();
    for (int i = 0; i < f.rows; ++i)
      for (int j = 0; j < f.columns; ++j) f.numbers()[i + j * f.rows] = at(i, j);
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
      const py::array_t<double> rows = array_from(x, name, {2});
      if (rows.shape(1) != f.rows)
        refuse_value("shape of " + name + " = " + std::string(py::str(rows.attr("shape"))) +
                     ": expected (N, " + std::to_string(f.rows) + ")");
      const auto at = rows.unchecked<2>();
      double* to = f.resize(f.at, static_cast<std::size_t>(rows.shape(0)));
      for (py::ssize_t i = 0; i < rows.shape(0); ++i)
        for (int j = 0; j < f.rows; ++j) *to++ = at(i, j);
      return;
    }
    case kind::tables: {
      if (!PyList_Check(x.ptr()) && !PyTuple_Check(x.ptr()))
        refuse_type(name + " = " + shown(x) + ": expected a list of dicts");
      const auto list = py::reinterpret_borrow<py::sequence>(x);
      const std::vector<rt::field_list> tables =
          f.resize_tables == nullptr ? f.tables : f.resize_tables(f.at, list.size());
      if (list.size() != tables.size())
        refuse_value("length of " + name + " = " + std::to_string(list.size()) + ": expected " +
                     std::to_string(tables.size()));
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
    if (const std::string called = py::str(key); std::ranges::find(names, called) == names.end())
      refuse_type(owner + " has no parameter '" + called + "': expected " +
                  (names.empty() ? "none" : joined(names)) + rt::did_you_mean(called, names));
  for (const field& f : fields)
    if (const std::string name = name_of(f); given.contains(name.c_str()))
      assign(f, given[name.c_str()], prefix + name, broadcasts);
}

py::object rows_as_lists(const double* first, int rows, int columns) {
  if (rows == 1 && columns == 1) return py::float_(*first);
  if (columns == 1) return list_of(std::span(first, static_cast<std::size_t>(rows)));
  py::list all;
  for (int i = 0; i < rows; ++i) {
    py::list row;
    for (int j = 0; j < columns; ++j) row.append(first[i + j * rows]);
    all.append(row);
  }
  return all;
}

py::dict values_of(const rt::field_list& fields);
py::object value_of(const field& f) {
  switch (f.type) {
    case kind::numbers: return rows_as_lists(f.numbers(), f.rows, f.columns);
    case kind::whole: return py::int_(f.get(f.at));
    case kind::truth: return py::bool_(f.get(f.at) != 0);
    case kind::text: return py::str(f.text());
    case kind::choice:
      return py::str(std::string(ph::choices_of(f.about).at(static_cast<std::size_t>(f.get(f.at)))));
    case kind::points: {
      py::list all;
      const std::size_t count = f.size(f.at);
      const double* at = f.resize(f.at, count);
      for (std::size_t i = 0; i < count; ++i, at += f.rows) all.append(rows_as_lists(at, f.rows, 1));
      return all;
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
  const rt::catalogue& all = example::catalogue();
  py::dict found;
  const auto add = [&](const char* list, const auto& entries, int dimension) {
    if (!found.contains(list)) found[list] = py::dict();
    for (const auto& e : entries) {
      const py::dict names = found[list];
      if (!names.contains(e.name.c_str())) names[e.name.c_str()] = py::list();
      if (dimension > 0) names[e.name.c_str()].attr("append")(dimension);
    }
  };
  add("mechanism", all.mechanisms(), 0);
  add("law", all.laws(), 0);
  add("brake_model", all.brake_models(), 0);
  add("shape", all.shapes<2>(), 2);
  add("shape", all.shapes<3>(), 3);
  add("effect", all.effects<2>(), 2);
  add("effect", all.effects<3>(), 3);
  py::list made_of_shapes;
  for (const auto& s : all.shapes<2>())
    if (s.takes_shape) made_of_shapes.append(s.name);
  found["made_of_shapes"] = made_of_shapes;
  return found;
}

}  // namespace

named::named(const std::string& of, const std::string& called, int d)
    : list(of), name(called), dimension(d), table(defaults_of(of, called, d)) {}

void named::assign(const py::dict& given) {
  assign_all(table.fields(), given, name, "", list == "brakes");
  if (const std::string error = table.error(); !error.empty()) refuse_value(error);
  table.for_each_suspicious([](const char*, const std::string& error) { warn(error); });
}

py::dict to_dict(rt::any_parameters table) { return values_of(table.fields()); }

void bind_named(py::module_& module) {
  py::class_<named>(module, "named")
      .def(py::init(
          [](const std::string& list, const std::string& name, int dimension, const py::dict& given) {
            named n(list, name, dimension);
            n.assign(given);
            return n;
          }))
      .def_static("unlimited_brakes",
                  [](int count) {
                    rt::brake_numbers brakes(count);
                    brakes.torque_limit.assign(static_cast<std::size_t>(count),
                                               std::numeric_limits<double>::infinity());
                    named n("brakes", "", count);
                    n.table = rt::any_parameters(brakes);
                    return n;
                  })
      .def("parameters", [](const named& n) { return to_dict(n.table); });
  module.def("lists", &lists);
  module.def("fields", [](const std::string& list, const std::string& name, int dimension) {
    return described(named(list, name, dimension).table.fields());
  });
}

}  // namespace passive_haptics_python
