/// @file
/// Reads a log of docs/guide/log.md line by line, and says what is wrong with it, where, and what was
/// expected.
#pragma once

#include <passive_haptics/scene/files/text_lines.hpp>

#include <istream>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace example {

/// A log is not as it should be; the text names file, line, column and expectation.
struct log_error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Columns are found by name, in any order, beside others that nobody needs. Memory does not grow with the
/// log. A log without lines on version and units is taken as one of this version in the units that are read.
/// Cells are separated by commas, semicolons or tabs, as the names are. A cell may be in quotes, the names
/// behind a #, a line "sep=;" before them.
class log_reader {
 public:
  static constexpr std::size_t max_line_length =
      4096;  ///< Longer lines are a mistake, not a log [characters].

  /// Reads the header. name: of the file, for the messages.
  log_reader(std::istream& in, std::string name);

  /// The names of all columns, in their order.
  const std::vector<std::string>& names() const { return names_; }
  /// Whether the log names units.
  bool has_units() const { return !units_.empty(); }
  /// Where a column stands, if it is there.
  std::optional<std::size_t> find(std::string_view name) const;
  /// Where a column stands whose unit is one of these.
  std::size_t column(std::string_view name, const std::vector<std::string_view>& units) const;
  /// Its unit; empty where the log names none.
  std::string_view unit(std::size_t column) const;

  /// Goes to the next line; false at the end of the log. Its time `t` is never before that of the line above.
  bool next();
  /// The number in a column of this line, NaN in an empty cell.
  double number(std::size_t column) const;
  /// The text in a column of this line, empty in an empty cell.
  std::string text(std::size_t column) const;
  /// Throws the log_error of this line; column: from 1, or 0 for the whole line.
  [[noreturn]] void fail(std::size_t column, const std::string& found, const std::string& expected) const;
  /// Number of the line that was read last, from 1.
  std::size_t line_number() const { return lines_.number(); }

 private:
  bool next_line();
  [[noreturn]] void fail(std::size_t column, const std::string& error) const;
  void split(std::string_view line, std::vector<std::string_view>& fields) const;
  void read_header();
  void read_remark();
  bool take_names(std::string_view line);

  passive_haptics::detail::text_lines lines_;
  std::string file_, header_, unit_cells_;
  std::vector<std::string> names_, units_;
  std::vector<std::string_view> fields_;
  std::size_t header_number_ = 0, time_column_ = 0;
  double time_ = 0;
  char separator_ = ',';
  bool row_is_read_ = false;  // as it was no line of names
  bool has_version_ = false;  // so that each line has an end
};

}  // namespace example
