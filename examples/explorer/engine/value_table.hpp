/// @file
/// A flat table of named numbers: all that the page shows, with label, symbol, equation and unit of each.
#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace explorer {

/// Some places of the table.
struct named_value {
  const char* id;        ///< Its name in the page.
  const char* label;     ///< In words.
  const char* symbol;    ///< As in the paper; empty where it has none.
  const char* equation;  ///< Its number in the paper; empty where it has none.
  std::string unit;      ///< "1" for a ratio, "" for a word.
  const char* group;     ///< Its part of the page: motion, forces, brakes, decision, simulation.
  int size = 1;          ///< Numbers.
  int columns = 1;       ///< Numbers in a row.
  std::vector<std::string> words = {};  ///< For an enumeration, which counts from 0.
  int offset = 0;                       ///< The first number; the table sets it.
};

/// The numbers and their names.
class value_table {
 public:
  /// With these values, all 0.
  explicit value_table(std::vector<named_value> names) : names_(std::move(names)) {
    int size = 0;
    for (named_value& v : names_) v.offset = std::exchange(size, size + v.size);
    numbers_.resize(std::size_t(size));
  }
  /// All numbers.
  int size() const { return static_cast<int>(numbers_.size()); }
  /// The numbers.
  double* data() { return numbers_.data(); }
  /// The names.
  const std::vector<named_value>& names() const { return names_; }

  /// Sets all numbers.
  void fill(double x) { std::fill(numbers_.begin(), numbers_.end(), x); }
  /// The numbers of a value; none if the table has none of this name.
  std::span<double> value(std::string_view id) {
    const auto found = std::find_if(names_.begin(), names_.end(), [&](const auto& v) { return id == v.id; });
    if (found == names_.end()) return {};
    return {numbers_.data() + found->offset, std::size_t(found->size)};
  }
  /// The first of them.
  double* operator[](std::string_view id) { return value(id).data(); }
  /// Sets a value of one number.
  void put(std::string_view id, double x) { *(*this)[id] = x; }
  /// Sets the first numbers of a value.
  template <class Values>
    requires requires(const Values& v) { v.size(); }
  void put(std::string_view id, const Values& values) {
    std::copy_n(values.data(), values.size(), (*this)[id]);
  }

 private:
  std::vector<named_value> names_;
  std::vector<double> numbers_;
};

}  // namespace explorer
