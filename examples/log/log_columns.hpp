/// A complete log in memory, by column.
#pragma once

#include <log/log_reader.hpp>

#include <cstddef>
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
  std::size_t size() const { return is_words() ? words.size() : numbers.size(); }
};

/// Reads all columns. Those with a unit are numbers. In a log without units, known_columns have their types;
/// others are numbers with unit "1" if each of their cells is one. Throws log_error. between: called every
/// few thousand lines; its exceptions end the call.
std::vector<log_column> columns_of(log_reader& log, const std::function<void()>& between = {});

/// Text of columns of equal length; with_header: after version, units and names.
std::string log_text(const std::vector<log_column>& columns, bool with_header);

/// Throws log_error if a log differs from these columns in any bit. This detects values that a log cannot
/// contain: a comma in a name, a time that goes back, an infinite number, a word of two lines.
void require_equal(log_reader& log, const std::vector<log_column>& columns,
                   const std::function<void()>& between = {});

}  // namespace example
