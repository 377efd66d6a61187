/// @file
/// Structs of parameters as dictionaries of Python, by their tables (passive_haptics/core/parameters.hpp).
#pragma once

#include <passive_haptics_python/from_python.hpp>

#include <passive_haptics/core/parameter_text.hpp>

#include <pybind11/stl.h>

#include <algorithm>
#include <string>
#include <type_traits>
#include <vector>

namespace passive_haptics_python {

/// A struct without parameters.
struct no_parameters {
  /// The table.
  static constexpr auto members() { return ph::member_table(); }
};

namespace detail {

template <class V>
concept Matrix = requires { requires V::ColsAtCompileTime != 1; };
template <class V>
concept Column = requires { requires V::ColsAtCompileTime == 1; };

// Of a matrix or of an array.
template <class V>
std::size_t rows_of(const V& value) {
  if constexpr (Matrix<V>) return std::size_t(value.rows());
  else return value.size();
}

}  // namespace detail

/// The name of a member in Python: with a _ behind it where it is a keyword there, "from_".
inline std::string python_name(const ph::member_description& about) {
  const py::object is_keyword = py::module_::import("keyword").attr("iskeyword");
  return py::cast<bool>(is_keyword(about.name)) ? std::string(about.name) + "_" : about.name;
}

/// The names of the members, in the order of the table.
template <ph::Parameters P>
std::vector<std::string> member_names() {
  std::vector<std::string> names;
  ph::members_of<P>([&](const auto& m) { names.push_back(python_name(m)); });
  return names;
}

/// The names with commas, for a message.
inline std::string joined(const std::vector<std::string>& names, const char* between = ", ") {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : between) + name;
  return text;
}

template <ph::Parameters P>
void assign_members(P& p, const py::dict& given, const std::string& owner, const std::string& prefix = "");

/// Sets a value of a table to what a Python user gave; a TypeError or ValueError that begins with the name.
template <class V>
void assign(V& value, py::handle given, const ph::member_description& about, const std::string& name) {
  if constexpr (ph::Parameters<V>) {
    if (!PyDict_Check(given.ptr()))
      refuse_type(name + " = " + shown(given) + ", expected a dict of " + joined(member_names<V>()));
    assign_members(value, py::reinterpret_borrow<py::dict>(given), name, name + ".");
  } else if constexpr (std::is_enum_v<V>) {
    std::vector<std::string> words;
    for (const auto word : ph::choices_of(about)) words.emplace_back(word);
    const std::string expected = ", expected '" + joined(words, "' or '") + "'";
    if (!PyUnicode_Check(given.ptr())) refuse_type(name + " = " + shown(given) + expected);
    const auto found = std::find(words.begin(), words.end(), py::cast<std::string>(given));
    if (found == words.end()) refuse_value(name + " = " + shown(given) + expected);
    value = static_cast<V>(found - words.begin());
  } else if constexpr (std::is_same_v<V, bool>) {
    if (!PyBool_Check(given.ptr())) refuse_type(name + " = " + shown(given) + ", expected True or False");
    value = given.ptr() == Py_True;
  } else if constexpr (std::is_integral_v<V>) {
    value = static_cast<V>(whole_number_from(given, name));
  } else if constexpr (std::is_floating_point_v<V>) {
    value = static_cast<V>(number_from(given, name));
  } else if constexpr (detail::Column<V>) {
    value = vector_from<V::RowsAtCompileTime>(given, name).template cast<typename V::Scalar>();
  } else {
    if (!PySequence_Check(given.ptr()) || PyUnicode_Check(given.ptr()))
      refuse_type(name + " = " + shown(given) + ", expected a list");
    const auto list = py::reinterpret_borrow<py::sequence>(given);
    const std::size_t rows = detail::rows_of(value);
    if (list.size() != rows)
      refuse_value("length of " + name + " = " + std::to_string(list.size()) + ", expected " +
                   std::to_string(rows));
    for (std::size_t i = 0; i < rows; ++i) {
      const py::object row = list[i];
      const std::string place = name + "[" + std::to_string(i) + "]";
      if constexpr (detail::Matrix<V>)
        value.row(int(i)) = vector_from<V::ColsAtCompileTime>(row, place).transpose();
      else assign(value[i], row, about, place);
    }
  }
}

/// Sets the members that a dictionary names; the others stay. owner: whose they are, in messages.
template <ph::Parameters P>
void assign_members(P& p, const py::dict& given, const std::string& owner, const std::string& prefix) {
  const std::vector<std::string> names = member_names<P>();
  for (const auto& [key, value] : given) {
    if (std::find(names.begin(), names.end(), std::string(py::str(key))) == names.end())
      refuse_type(owner + " has no parameter " + std::string(py::repr(key)) + ", expected " +
                  (names.empty() ? "none" : joined(names)));
  }
  ph::for_each_member(p, [&](const ph::member_description& about, auto& value) {
    const std::string name = python_name(about);
    if (given.contains(name.c_str())) assign(value, given[name.c_str()], about, prefix + name);
  });
}

template <ph::Parameters P>
py::dict to_dict(const P& p);

/// A value of a table as numbers, texts, lists and dictionaries of Python.
template <class V>
py::object to_python(const V& value, const ph::member_description& about) {
  if constexpr (ph::Parameters<V>) {
    return to_dict(value);
  } else if constexpr (std::is_enum_v<V>) {
    return py::str(std::string(ph::choices_of(about).at(std::size_t(value))));
  } else if constexpr (std::is_arithmetic_v<V>) {
    return py::cast(value);
  } else {
    py::list list;
    if constexpr (detail::Matrix<V>) {
      for (int i = 0; i < value.rows(); ++i) {
        const Eigen::Matrix<typename V::Scalar, V::ColsAtCompileTime, 1> row = value.row(i);
        list.append(to_python(row, about));
      }
    } else {
      for (const auto& element : value) list.append(to_python(element, about));
    }
    return list;
  }
}

/// All members.
template <ph::Parameters P>
py::dict to_dict(const P& p) {
  py::dict all;
  ph::for_each_member(p, [&](const ph::member_description& about, const auto& value) {
    all[python_name(about).c_str()] = to_python(value, about);
  });
  return all;
}

/// The members that are not those of `usual`: what makes these parameters.
template <ph::Parameters P>
py::dict changed_members(const P& p, const P& usual) {
  py::dict changed;
  ph::members_of<P>([&](const auto& m) {
    const auto &value = p.*m.pointer, &before = usual.*m.pointer;
    const py::object now = to_python(value, m);
    if (now.equal(to_python(before, m))) return;
    if constexpr (ph::Parameters<std::remove_cvref_t<decltype(value)>>)
      changed[python_name(m).c_str()] = changed_members(value, before);
    else changed[python_name(m).c_str()] = now;
  });
  return changed;
}

}  // namespace passive_haptics_python
