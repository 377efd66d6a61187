/// @file
/// A whole log in memory, column by column, for programs that look at all of it at once.
#pragma once

#include <log/log_reader.hpp>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace example {

/// A column of a log: numbers or words, one for each line.
struct log_column {
  std::string name;                ///< "q1"
  std::string unit;                ///< "1" of a number without one, "" of words.
  std::vector<double> numbers;     ///< NaN in an empty cell; none of words.
  std::vector<std::string> words;  ///< None of numbers.

  bool is_words() const { return unit.empty(); }
  std::size_t size() const { return is_words() ? words.size() : numbers.size(); }
};

/// All columns. Those with a unit are numbers. In a log without units those of known_columns are what they
/// are there; any other is numbers where each of its cells is one, with "1" as its unit. Throws log_error.
/// between: called every few thousand lines; what it throws ends the call.
std::vector<log_column> columns_of(log_reader& log, const std::function<void()>& between = {});

/// The lines of these columns, which are all as long; with_header: below version, units and names.
std::string log_text(const std::vector<log_column>& columns, bool with_header);

/// Throws log_error if a log is not the one that was to be written, to the last bit. So whatever cannot stand
/// in a log is found: a comma in a name, a time that goes back, an infinite number, a word of two lines.
void require_equal(log_reader& log, const std::vector<log_column>& columns,
                   const std::function<void()>& between = {});

}  // namespace example
