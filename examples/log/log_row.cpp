#include <log/log_row.hpp>
#include <log/number_text.hpp>

#include <cmath>

namespace example {
namespace {

// True if a CSV reader would change an unquoted cell.
bool needs_quotes(std::string_view text) {
  return text.find_first_of(",\"") != text.npos || text.starts_with(' ') || text.ends_with(' ');
}

void append_quoted(std::string& line, std::string_view text, std::string_view marked, char mark) {
  line += '"';
  for (const char c : text) {
    if (marked.find(c) != marked.npos) line += mark;
    line += c;
  }
  line += '"';
}

}  // namespace

log_row::cell& log_row::next(std::string_view name, std::string_view unit) {
  if (used_ == cells_.size()) {
    cells_.emplace_back();
    columns_.push_back({std::string(name), std::string(unit)});
  }
  cell& c = cells_[used_++];
  c.text.clear();
  c.is_word = unit.empty();
  return c;
}

void log_row::put(std::string_view name, std::string_view unit, double value) {
  std::string& text = next(name, unit).text;
  if (std::isfinite(value) && !blank_) set_to_number(text, value);
}

void log_row::put(std::string_view name, std::string_view unit, std::int64_t value) {
  std::string& text = next(name, unit).text;
  if (!blank_) set_to_number(text, value);
}

void log_row::put(std::string_view name, std::string_view word) {
  std::string& text = next(name, "").text;
  if (!blank_) text = word;
}

// Composes the name only once.
void log_row::put_part(const std::string& name, const std::string& part, std::string_view unit,
                       double value) {
  put(used_ < cells_.size() ? name : name + part, unit, value);
}

std::string log_row::header() const {
  std::string names, units;
  for (const auto& [name, unit] : columns_) {
    (names += names.empty() ? "" : ",") += name;
    (units += &unit == &columns_[0].unit ? "" : ",") += unit;
  }
  std::string all = "# passive_haptics log ";
  all += std::to_string(log_version);
  return all.append("\n# units: ").append(units).append("\n").append(names).append("\n");
}

const std::string& log_row::csv() {
  line_.clear();
  for (std::size_t i = 0; i < used_; ++i) {
    const std::string& text = cells_[i].text;
    if (needs_quotes(text)) append_quoted(line_, text, "\"", '"');
    else line_ += text;
    line_ += ',';
  }
  line_.back() = '\n';
  return line_;
}

const std::string& log_row::json() {
  line_ = '{';
  for (std::size_t i = 0; i < used_; ++i) {
    const auto& [text, is_word] = cells_[i];
    if (text.empty()) continue;
    if (line_.size() > 1) line_ += ',';
    append_quoted(line_, columns_[i].name, "", '\\');
    line_ += ':';
    if (is_word) append_quoted(line_, text, "\"\\", '\\');
    else line_ += text;
  }
  line_ += '}';
  return line_;
}

}  // namespace example
