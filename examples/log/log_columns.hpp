/// A complete log in memory, by column.
#pragma once

#include <log/log_reader.hpp>

#include <functional>
#include <string>
#include <vector>

namespace example {

/// A column of a log: numbers or words, one per line.
struct log_column {
  std::string name;                ///< "q1"
  std::string unit;                ///< "1" for a number without unit, "" for words.
  std::vector<double> numbers;     ///< NaN for an empty cell; none for words.
  std::vector<std::string> words;  ///< None for numbers.

  bool is_words() const { return unit.empty(); }
};

/// Reads all columns. Those with a unit are numbers. In a log without units, known_columns have their types;
/// others are numbers with unit "1" if each of their cells is one. Throws log_error. between: called every
/// few thousand lines; its exceptions end the call.
std::vector<log_column> columns_of(log_reader& log, const std::function<void()>& between = {});

}  // namespace example
