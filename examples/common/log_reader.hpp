/// @file
/// Reads a log of numbers line by line, and says what is wrong with a line, where, and what was expected.
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <istream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace example {

/// A log is not as it should be; the text names line, column and expectation.
struct log_error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A comma-separated log: a header with exactly these names, then lines of finite numbers, the first of which
/// (a time) never decreases. Memory does not grow with the log.
class log_reader {
 public:
  static constexpr std::size_t longest_line = 4096;  ///< Longer lines are a mistake, not a log [characters].

  /// Reads and checks the header.
  log_reader(std::istream& in, std::vector<std::string> columns)
      : in_(in), columns_(std::move(columns)), values_(columns_.size()) {
    if (!next_line()) fail(0, "the log is empty", "the header '" + header() + "'");
    if (line_.rfind("\xEF\xBB\xBF", 0) == 0) line_.erase(0, 3);  // a byte order mark
    const auto names = split();
    for (std::size_t i = 0; i < names.size() || i < columns_.size(); ++i) {
      if (i >= names.size()) fail(i + 1, "the header ends", "a column '" + columns_[i] + "'");
      if (i >= columns_.size()) fail(i + 1, "column '" + std::string(names[i]) + "'", "no further column");
      if (names[i] != columns_[i])
        fail(i + 1, "column '" + std::string(names[i]) + "'", "a column '" + columns_[i] + "'");
    }
  }

  /// The numbers of the next line, nullptr at the end of the log.
  const std::vector<double>* next() {
    if (!next_line()) return nullptr;
    if (line_.empty()) {  // blank lines may end a log
      while (next_line()) {
        if (!line_.empty()) fail(0, "a blank line before this one", "numbers in each line");
      }
      return nullptr;
    }
    const auto fields = split();
    for (std::size_t i = 0; i < fields.size(); ++i) {
      if (i >= columns_.size())
        fail(i + 1, "'" + std::string(fields[i]) + "'", std::to_string(columns_.size()) + " numbers");
      values_[i] = number(fields[i], i);
    }
    if (fields.size() < columns_.size()) {
      fail(fields.size() + 1, "the line ends", "a number for '" + columns_[fields.size()] + "'");
    }
    if (values_[0] < time_)
      fail(1, "time " + std::string(fields[0]), "no time before that of the line above");
    time_ = values_[0];
    return &values_;
  }

  /// Number of the line that was read last, from 1.
  std::size_t line_number() const { return number_; }

 private:
  [[noreturn]] void fail(std::size_t column, const std::string& found, const std::string& expected) const {
    std::string where = "line " + std::to_string(number_);
    if (column > 0) where += ", column " + std::to_string(column);
    throw log_error(where + ": " + found + ", expected " + expected);
  }

  std::string header() const {
    std::string text;
    for (const auto& name : columns_) text += (text.empty() ? "" : ",") + name;
    return text;
  }

  bool next_line() {
    line_.clear();
    ++number_;
    std::streambuf& buffer = *in_.rdbuf();
    for (int c = buffer.sbumpc(); c != std::istream::traits_type::eof(); c = buffer.sbumpc()) {
      if (c == '\n') {
        if (!line_.empty() && line_.back() == '\r') line_.pop_back();
        return true;
      }
      if (c == '\0') fail(0, "a zero byte", "text");
      line_.push_back(static_cast<char>(c));
      if (line_.size() > longest_line)
        fail(0, "more than " + std::to_string(longest_line) + " characters", "a shorter line");
    }
    return !line_.empty();
  }

  std::vector<std::string_view>& split() {
    fields_.clear();
    std::string_view rest = line_;
    for (;;) {
      const std::size_t comma = rest.find(',');
      std::string_view field = rest.substr(0, comma);
      while (!field.empty() && field.front() == ' ') field.remove_prefix(1);
      while (!field.empty() && field.back() == ' ') field.remove_suffix(1);
      fields_.push_back(field);
      if (comma == std::string_view::npos) return fields_;
      rest.remove_prefix(comma + 1);
    }
  }

  double number(std::string_view field, std::size_t i) const {
    const auto refuse = [&](const std::string& found, const std::string& more = "") {
      fail(i + 1, found, "a finite number for '" + columns_[i] + "'" + more);
    };
    const auto quoted = [](std::string_view text) { return "'" + std::string(text) + "'"; };
    if (field.empty()) refuse("an empty field");
    double value = 0;
    const char* const end = field.data() + field.size();
    const bool plus =
        field.front() == '+' && field.size() > 1 && field[1] != '-';  // from_chars takes no plus
    const auto [stop, error] = std::from_chars(field.data() + (plus ? 1 : 0), end, value);
    if (error == std::errc::result_out_of_range) refuse(quoted(field) + " is out of range");
    if (error != std::errc()) refuse(quoted(field));
    if (stop != end) {
      if (*stop == ';' || *stop == '\t') fail(i + 1, quoted(field), "fields separated by commas");
      refuse(quoted(std::string_view(stop, static_cast<std::size_t>(end - stop))) + " after a number",
             " alone, without a unit");
    }
    if (!std::isfinite(value)) refuse(quoted(field));
    return value;
  }

  std::istream& in_;
  std::vector<std::string> columns_;
  std::vector<double> values_;
  std::vector<std::string_view> fields_;
  std::string line_;
  std::size_t number_ = 0;
  double time_ = -HUGE_VAL;
};

}  // namespace example
