/// @file
/// A flat table of named numbers: all that the page shows, with label, symbol, equation and unit of each.
#pragma once

#include "json.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace explorer {

/// What stands in some places of the table.
struct named_value {
  const char* id;                       ///< As exports.hpp lists it.
  const char* label;                    ///< In words.
  const char* symbol;                   ///< As in the paper; empty where it has none.
  const char* equation;                 ///< Its number in the paper; empty where it has none.
  std::string unit;                     ///< "1" for a ratio, "" for a word.
  const char* group;                    ///< Where it is shown: motion, forces, brakes, decision.
  int size = 1;                         ///< Numbers.
  int columns = 1;                      ///< Of them in a row.
  std::vector<std::string> words = {};  ///< Of an enumeration, which counts from 0.
  int offset = 0;                       ///< Of the first number; the table sets it.
};

/// The numbers and their names.
class value_table {
 public:
  /// Adds a value; returns its offset.
  int add(named_value about) {
    about.offset = size();
    numbers_.resize(numbers_.size() + std::size_t(about.size), 0.0);
    names_.push_back(std::move(about));
    return names_.back().offset;
  }
  /// All numbers.
  int size() const { return static_cast<int>(numbers_.size()); }
  /// The numbers.
  double* data() { return numbers_.data(); }
  /// The names.
  const std::vector<named_value>& names() const { return names_; }

  /// Sets one number.
  void put(int offset, double x) { numbers_[std::size_t(offset)] = x; }
  /// Sets a vector or, row by row, a matrix; `width` places for each row, the rest 0.
  template <class Matrix>
  void put_rows(int offset, const Matrix& values, int width) {
    for (int i = 0; i < values.rows(); ++i)
      for (int j = 0; j < width; ++j)
        numbers_[std::size_t(offset + i * width + j)] = j < values.cols() ? double(values(i, j)) : 0.0;
  }
  /// Sets a column of numbers; `width` places, the rest 0.
  template <class Vector>
  void put_column(int offset, const Vector& values, int width) {
    for (int i = 0; i < width; ++i)
      numbers_[std::size_t(offset + i)] = i < values.size() ? double(values[i]) : 0.0;
  }

  /// The list of names (exports.hpp).
  void write(json_writer& json) const {
    json.list([&] {
      for (const named_value& v : names_) {
        json.object([&] {
          json.put("id", v.id);
          json.put("label", v.label);
          json.put("symbol", v.symbol);
          json.put("equation", v.equation);
          json.put("unit", v.unit);
          json.put("group", v.group);
          json.put("offset", v.offset);
          json.put("size", v.size);
          json.put("columns", v.columns);
          if (!v.words.empty()) json.put_list("words", v.words);
        });
      }
    });
  }

 private:
  std::vector<named_value> names_;
  std::vector<double> numbers_;
};

}  // namespace explorer
