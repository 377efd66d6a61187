/// @file
/// Settings: lines NAME=VALUE, the one form in which a device is written down, shared and read.
#pragma once

#include <log/number_text.hpp>

#include <passive_haptics/core/parameter_text.hpp>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace explorer {

namespace ph = passive_haptics;

/// A text of lines NAME=VALUE, in which each name stands once: the last line counts.
class settings {
 public:
  /// None.
  settings() = default;
  /// Of this text; empty lines and lines that begin with # are skipped. Throws std::invalid_argument.
  explicit settings(std::string_view text);

  /// The value, or nullptr.
  const std::string* find(std::string_view name) const;
  /// Sets a value.
  void set(std::string_view name, std::string_view value);
  /// Sets all values of these.
  void set(const settings& others);
  /// All lines.
  std::string text() const;
  /// Names and values.
  const std::vector<std::pair<std::string, std::string>>& lines() const { return lines_; }

 private:
  std::vector<std::pair<std::string, std::string>> lines_;
};

/// The shortest text of a number.
std::string number_text(double value);
/// "name = found, expected ...", thrown as std::invalid_argument.
[[noreturn]] void refuse(std::string_view name, std::string_view found, std::string_view expected);
/// One number. Throws std::invalid_argument with the name.
double number_of(std::string_view name, std::string_view text);
/// The numbers between commas. Throws std::invalid_argument with the name.
std::vector<double> numbers_of(std::string_view name, std::string_view text);

/// Reads the value of a member of a table. Throws std::invalid_argument.
template <class V>
void read_value(V& value, const ph::member_description& about, const std::string& name,
                const std::string& text) {
  if constexpr (std::is_same_v<V, std::string>) {
    value = text;
  } else if constexpr (std::is_enum_v<V>) {
    const auto words = ph::choices_of(about);
    const auto word = std::find(words.begin(), words.end(), text);
    if (word == words.end()) refuse(name, text, std::string("one of ") + about.choices);
    value = static_cast<V>(word - words.begin());
  } else if constexpr (std::is_arithmetic_v<V>) {
    value = static_cast<V>(number_of(name, text));
  } else {
    const auto found = numbers_of(name, text);
    if (found.size() != std::size_t(value.size()))
      refuse(name, text, std::to_string(value.size()) + " numbers with commas between");
    std::copy(found.begin(), found.end(), value.data());
  }
}

/// The value of a member as text that read_value() reads back to the last bit.
template <class V>
std::string value_text(const V& value, const ph::member_description& about) {
  if constexpr (std::is_same_v<V, std::string>) {
    return value;
  } else if constexpr (std::is_enum_v<V>) {
    return std::string(ph::choices_of(about).at(static_cast<std::size_t>(value)));
  } else if constexpr (std::is_arithmetic_v<V>) {
    return number_text(static_cast<double>(value));
  } else {
    std::string text;
    for (const double x : value) text.append(text.empty() ? "" : ",").append(number_text(x));
    return text;
  }
}

/// Calls f(name, member, value) for each member of a table and of the tables within, names with `prefix`.
template <class P, class F>
void for_each_setting(P& table, const std::string& prefix, F&& f) {
  ph::for_each_member(table, [&](const ph::member_description& about, auto& value) {
    if constexpr (ph::Parameters<std::remove_cvref_t<decltype(value)>>)
      for_each_setting(value, prefix + about.name + ".", f);
    else f(prefix + about.name, about, value);
  });
}

}  // namespace explorer
