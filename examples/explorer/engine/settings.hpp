/// @file
/// Settings: lines NAME=VALUE, the one form in which a device is written down, shared and read.
#pragma once

#include <log/number_text.hpp>

#include <passive_haptics/core/parameter_text.hpp>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace explorer {

namespace ph = passive_haptics;

/// A text of lines NAME=VALUE, in which each name stands once: the last line counts.
class settings {
 public:
  /// None.
  settings() = default;
  /// From a text; empty lines and lines that begin with # are skipped. Throws std::invalid_argument.
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
/// "name = found: expected ...", thrown as std::invalid_argument.
[[noreturn]] void refuse(std::string_view name, std::string_view found, std::string_view expected);
/// "one of A, B", of the names of the elements of a list.
template <class Elements, class Name>
std::string names_of(const Elements& all, Name name) {
  std::string text = "one of ";
  for (const auto& one : all) text.append(&one == &all.front() ? "" : ", ").append(name(one));
  return text;
}
/// The numbers between commas. Throws std::invalid_argument with the name.
std::vector<double> numbers_of(std::string_view name, std::string_view text);

}  // namespace explorer
