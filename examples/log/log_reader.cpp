#include <log/log_reader.hpp>
#include <log/log_row.hpp>

#include <passive_haptics/core/text.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace example {
namespace {

std::string in_quotes(std::string_view text) { return std::string("'").append(text).append("'"); }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

std::string_view without_quotes(std::string_view text) {
  const bool quoted = text.size() > 1 && text.front() == '"' && text.back() == '"';
  return quoted ? text.substr(1, text.size() - 2) : text;
}

bool take(std::string_view& text, std::string_view beginning) {
  if (!text.starts_with(beginning)) return false;
  text.remove_prefix(beginning.size());
  return true;
}

// Line by which spreadsheets define the separator
bool is_separator_line(std::string_view line) { return line.size() == 5 && line.starts_with("sep="); }

}  // namespace

log_reader::log_reader(std::istream& in, std::string name)
    : lines_(in, max_line_length), file_(std::move(name)) {
  lines_.limit_zeros(1);  // the end of a C string
  read_header();
  for (std::size_t i = 0; i < names_.size(); ++i)
    if (find(names_[i]) != i) fail(i + 1, "a second " + in_quotes(names_[i]), "each name once");
  if (!unit_cells_.empty()) {
    split(unit_cells_, fields_);
    units_.assign(fields_.begin(), fields_.end());
    if (units_.size() != names_.size())
      fail(0, std::to_string(names_.size()) + " names and the units " + in_quotes(unit_cells_),
           "a unit for each name, separated as the names are; write them so, or remove the line of units");
  }
  time_column_ = column("t", {"s"});
  time_ = -std::numeric_limits<double>::infinity();
}

// The names are in the first line that is not a comment, or, as written by NumPy, in a comment above a row.
void log_reader::read_header() {
  const char* const expected = "a line of names, t,q1,...";
  if (!next_line()) fail(0, "the log is empty", expected);
  while (lines_.line().starts_with('#') || is_separator_line(lines_.line())) {
    if (lines_.line().starts_with('#')) read_remark();
    if (next_line()) continue;
    if (names_.empty()) fail(0, "the log ends", expected);
    return;
  }
  row_is_read_ = !take_names(lines_.line()) && !names_.empty();
  if (names_.empty())
    fail(0, "no column 't'",
         "one among " + in_quotes(lines_.line()) + ", separated by commas, semicolons or tabs");
}

void log_reader::read_remark() {
  std::string_view text = lines_.line();
  if (take(text, "# passive_haptics log ")) {
    has_version_ = true;
    if (text != std::to_string(log_version))
      fail(0, std::string("version ").append(text), "version " + std::to_string(log_version));
  } else if (take(text, "# units:")) {
    unit_cells_ = text;
  } else {
    take_names(text.substr(1));
  }
}

// Finds the names in a line with a t, for any separator.
bool log_reader::take_names(std::string_view line) {
  for (const char separator : {',', ';', '\t'}) {
    const char before = std::exchange(separator_, separator);
    split(line, fields_);
    if (std::find(fields_.begin(), fields_.end(), "t") != fields_.end()) {
      names_.assign(fields_.begin(), fields_.end());
      header_ = trimmed(line);
      header_number_ = lines_.number();
      return true;
    }
    separator_ = before;
  }
  return false;
}

std::optional<std::size_t> log_reader::find(std::string_view name) const {
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (found == names_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - names_.begin());
}

std::size_t log_reader::column(std::string_view name, const std::vector<std::string_view>& units) const {
  const auto found = find(name);
  if (!found) fail(0, "no column " + in_quotes(name), "one among " + in_quotes(header_));
  const std::string_view of = unit(*found);
  if (!of.empty() && std::find(units.begin(), units.end(), of) == units.end()) {
    std::string choices;
    for (const auto one : units) choices.append(choices.empty() ? "" : " or ").append(one);
    fail(*found + 1, in_quotes(name) + " in " + in_quotes(of), "it in " + choices);
  }
  return *found;
}

std::string_view log_reader::unit(std::size_t column) const {
  return units_.empty() ? std::string_view() : units_[column];
}

bool log_reader::next() {
  if (!std::exchange(row_is_read_, false) && !next_line()) return false;
  if (lines_.line().empty()) {  // a log may end with blank lines
    while (next_line())
      if (!lines_.line().empty()) fail(0, "a blank line before this one", "numbers in each line");
    return false;
  }
  if (has_version_ && lines_.is_last())
    fail(0, "the line has no newline",
         "one at the end of each line; the log was cut off: remove this line, or end it");
  split(lines_.line(), fields_);
  if (fields_.size() > names_.size())
    fail(names_.size() + 1, in_quotes(fields_[names_.size()]), std::to_string(names_.size()) + " cells");
  if (fields_.size() < names_.size())
    fail(fields_.size() + 1, "the line ends", "a cell for " + in_quotes(names_[fields_.size()]));
  const double t = number(time_column_);
  if (!(t >= time_))
    fail(time_column_ + 1, std::isnan(t) ? "no time" : "time " + std::string(fields_[time_column_]),
         "no time before that of the line above");
  time_ = t;
  return true;
}

double log_reader::number(std::size_t column) const {
  const std::string_view field = fields_[column];
  if (field.empty()) return std::numeric_limits<double>::quiet_NaN();
  double value = 0;
  const char* const end = field.data() + field.size();
  const auto [stop, error] = passive_haptics::detail::read_number(field, value);
  if (error == std::errc() && stop == end && std::isfinite(value)) return value;
  const std::string expected = "a finite number for " + in_quotes(names_[column]);
  if (error == std::errc::result_out_of_range)
    fail(column + 1, in_quotes(field) + " is out of range", expected);
  const bool ends_log = lines_.is_last() && column + 1 == fields_.size();
  const std::string cause(passive_haptics::detail::cause_of_no_number(field, ends_log));
  if (error != std::errc() || stop == end || !cause.empty())
    fail(column + 1, in_quotes(field), expected + cause);
  if (*stop == ';' || *stop == '\t') fail(column + 1, in_quotes(field), "cells separated as the names are");
  fail(column + 1, in_quotes(field.substr(static_cast<std::size_t>(stop - field.data()))) + " after a number",
       expected + " without a unit; write units into the header");
}

// Quotes within a quoted cell are doubled.
std::string log_reader::text(std::size_t column) const {
  std::string text(fields_[column]);
  for (std::size_t at = 0; (at = text.find("\"\"", at)) != text.npos; ++at) text.erase(at, 1);
  return text;
}

void log_reader::fail(std::size_t column, const std::string& found, const std::string& expected) const {
  fail(column, std::string(found).append(": expected ").append(expected));
}

void log_reader::fail(std::size_t column, const std::string& error) const {
  std::string where = file_;
  where.append(", line ").append(std::to_string(row_is_read_ ? header_number_ : lines_.number()));
  if (column > 0) where.append(", column ").append(std::to_string(column));
  throw log_error(passive_haptics::detail::printable(where.append(": ").append(error)));
}

bool log_reader::next_line() {
  if (lines_.next()) return true;
  if (!lines_.error().empty()) fail(0, lines_.error());
  return false;
}

// Splits at separators outside quotes.
void log_reader::split(std::string_view line, std::vector<std::string_view>& fields) const {
  fields.clear();
  bool inside = false;
  std::size_t from = 0;
  for (std::size_t i = 0; i <= line.size(); ++i) {
    if (i < line.size() && line[i] == '"') inside = !inside;
    if (i < line.size() && (line[i] != separator_ || inside)) continue;
    fields.push_back(without_quotes(trimmed(line.substr(from, i - from))));
    from = i + 1;
  }
}

}  // namespace example
