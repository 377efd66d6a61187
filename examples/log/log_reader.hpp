/// Reads a log of docs/guide/log.md line by line, with errors that give the place and the expectation.
#pragma once

#include <passive_haptics/scene/files/text_lines.hpp>

#include <istream>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace example {

/// A malformed log; the text has file, line, column and expectation.
struct log_error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Columns are found by name, in any order; others are ignored. Memory does not grow with the log. A log
/// without lines for version and units is assumed to have this version and the units that are read. Cells and
/// names are separated by commas, semicolons or tabs. Cells may be quoted, names may follow a #, and a line
/// "sep=;" may precede them.
class log_reader {
 public:
  static constexpr std::size_t max_line_length = 4096;  ///< Maximum line length [characters].

  /// Reads the header. name: of the file, for errors.
  log_reader(std::istream& in, std::string name);

  const std::vector<std::string>& names() const { return names_; }
  /// True if the log has units.
  bool has_units() const { return !units_.empty(); }
  /// Index of a column, if it exists.
  std::optional<std::size_t> find(std::string_view name) const;
  /// Index of a column with one of these units.
  std::size_t column(std::string_view name, const std::vector<std::string_view>& units) const;
  /// Its unit; empty in a log without units.
  std::string_view unit(std::size_t column) const;

  /// Goes to the next line; false at the end of the log. Its time `t` never decreases.
  bool next();
  /// Number in a column of this line, NaN for an empty cell.
  double number(std::size_t column) const;
  /// Text in a column of this line.
  std::string text(std::size_t column) const;
  /// Throws the log_error of this line; column: from 1, or 0 for the whole line.
  [[noreturn]] void fail(std::size_t column, const std::string& found, const std::string& expected) const;
  /// Number of the last line, from 1.
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
  bool row_is_read_ = false;  // first row, if it was not a line of names
  bool has_version_ = false;  // requires an end of each line
};

}  // namespace example
