/// @file
/// What a parameter table says to a Python user: signatures for the stubs, units and ranges for help().
#pragma once

#include <passive_haptics_python/parameters.hpp>

#include <array>
#include <string>

namespace passive_haptics_python {

/// The type of a value of a table in a stub.
template <class V>
std::string stub_type(const ph::member_description& about) {
  if constexpr (ph::Parameters<V>) return "Mapping[str, object]";
  else if constexpr (std::is_enum_v<V>) {
    std::string words;
    for (const auto word : ph::choices_of(about))
      words.append(words.empty() ? "\"" : ", \"").append(word).append("\"");
    return "Literal[" + words + "]";
  } else if constexpr (std::is_same_v<V, bool>) return "bool";
  else if constexpr (std::is_integral_v<V>) return "int";
  else if constexpr (std::is_floating_point_v<V>) return "float";
  else if constexpr (detail::Column<V>) return "Numbers";
  else if constexpr (detail::Matrix<V>) return "Rows";
  else if constexpr (ph::Parameters<typename V::value_type>) return "Sequence[Mapping[str, object]]";
  else return "Rows";
}

/// The arguments of the table: "length_1: float = ..., length_2: float = ...".
template <ph::Parameters P>
std::string stub_arguments() {
  std::vector<std::string> all;
  const P p{};
  ph::for_each_member(p, [&](const ph::member_description& about, const auto& value) {
    all.push_back(python_name(about) + ": " + stub_type<std::remove_cvref_t<decltype(value)>>(about) +
                  " = ...");
  });
  return joined(all);
}

namespace detail {

// "a finite number > 0", or the words of an enumeration.
template <class V>
std::string expected_value(const ph::member_description& about) {
  if constexpr (std::is_enum_v<V>) return about.choices;
  else if constexpr (ph::Parameters<V>) return "a dict";
  else return ph::to_text(about.hard, std::is_integral_v<V>);
}

// "; default 0.15", or "; no default" where that of C++ is not valid, so that one must be given.
template <class V>
std::string default_text(const ph::member_description& about, const V& value) {
  if (!ph::check_value(about.name, value, about.unit, about.hard).empty()) return "; no default";
  return "; default " + std::string(py::repr(to_python(value, about)));
}

// A line for each member, that of a struct within another one indented.
template <ph::Parameters P>
void append_members(std::string& text, const P& p, const std::string& indent) {
  ph::for_each_member(p, [&](const ph::member_description& about, const auto& value) {
    using V = std::remove_cvref_t<decltype(value)>;
    text += indent + python_name(about);
    if (*about.unit != '\0') text += std::string(" [") + about.unit + "]";
    text += ": " + expected_value<V>(about);
    if constexpr (!ph::Parameters<V>) {
      if constexpr (requires { value.begin()->members(); }) {
        text += ", a list of " + std::to_string(value.size()) + " dicts\n";
        append_members(text, std::remove_cvref_t<decltype(*value.begin())>(), indent + "    ");
        return;
      } else {
        text += default_text(about, value);
      }
    }
    text += "\n";
    if constexpr (ph::Parameters<V>) append_members(text, value, indent + "    ");
  });
}

}  // namespace detail

/// A line for each parameter: its name, unit, range and default.
template <ph::Parameters P>
std::string parameter_lines() {
  std::string text;
  detail::append_members(text, P{}, "    ");
  return text.empty() ? "" : "Parameters:\n" + text;
}

}  // namespace passive_haptics_python
