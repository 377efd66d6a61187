#include <log/known_columns.hpp>
#include <log/log_columns.hpp>
#include <log/log_row.hpp>
#include <log/number_text.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

namespace example {
namespace {

constexpr std::size_t lines_between = 4096;

// A column while it is read. If it may be words, both forms are kept until a cell is not a number.
struct growing_column {
  log_column column;
  bool has_numbers, has_words;

  void add(const log_reader& log, std::size_t at) {
    if (has_words) column.words.push_back(log.text(at));
    if (!has_numbers) return;
    if (!has_words) return column.numbers.push_back(log.number(at));
    try {
      column.numbers.push_back(log.number(at));
    } catch (const log_error&) {
      has_numbers = false;
    }
  }
  log_column done() {
    if (has_numbers) column.words.clear();
    else column.numbers.clear();
    if (has_numbers && column.unit.empty()) column.unit = "1";
    return std::move(column);
  }
};

growing_column begin_column(const log_reader& log, std::size_t at) {
  const std::string& name = log.names()[at];
  const known_column* const known = find_known(name);
  if (known != nullptr && known->is_read) log.column(name, known->units);
  std::string unit(log.unit(at));
  if (!log.has_units() && known != nullptr) unit = known->units.front();
  const bool is_open = !log.has_units() && known == nullptr;
  const bool has_numbers = is_open || !unit.empty(), has_words = unit.empty();
  return {{name, std::move(unit), {}, {}}, has_numbers, has_words};
}

std::string shown(double x) {
  std::string text;
  set_to_number(text, x);
  return text;
}

bool same_bits(double a, double b) {
  return (std::isnan(a) && std::isnan(b)) ||
         std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

// Compares one cell.
void require_equal_cell(const log_reader& log, std::size_t at, const log_column& column, std::size_t line) {
  const std::string place = " for '" + column.name + "'";
  if (column.is_words()) {
    if (log.text(at) != column.words[line])
      log.fail(at + 1, "'" + column.words[line] + "'" + place,
               "a word of one line, in UTF-8, with paired quotes");
  } else if (!same_bits(log.number(at), column.numbers[line])) {
    log.fail(at + 1, shown(column.numbers[line]) + place, "a finite number, or NaN for what is not known");
  }
}

void require_equal_header(const log_reader& log, const std::vector<log_column>& columns) {
  for (std::size_t at = 0; at < columns.size(); ++at)
    if (at >= log.names().size() || log.names()[at] != columns[at].name || log.unit(at) != columns[at].unit)
      log.fail(at + 1, "column '" + columns[at].name + "' in '" + columns[at].unit + "'",
               "a name and a unit of one line, without a comma, quotes, or spaces around them");
  if (log.names().size() != columns.size())
    log.fail(0, std::to_string(log.names().size()) + " columns", std::to_string(columns.size()));
}

}  // namespace

std::vector<log_column> columns_of(log_reader& log, const std::function<void()>& between) {
  std::vector<growing_column> growing;
  for (std::size_t at = 0; at < log.names().size(); ++at) growing.push_back(begin_column(log, at));
  for (std::size_t line = 1; log.next(); ++line) {
    for (std::size_t at = 0; at < growing.size(); ++at) growing[at].add(log, at);
    if (line % lines_between == 0 && between) between();
  }
  std::vector<log_column> columns;
  for (growing_column& one : growing) columns.push_back(one.done());
  return columns;
}

std::string log_text(const std::vector<log_column>& columns, bool with_header) {
  log_row row;
  const auto put = [&](std::size_t line) {
    row.start();
    for (const log_column& c : columns) {
      if (c.is_words()) row.put(c.name, line < c.size() ? std::string_view(c.words[line]) : "");
      else row.put(c.name, c.unit, line < c.size() ? c.numbers[line] : 0.0);
    }
  };
  const std::size_t lines = columns.empty() ? 0 : columns.front().size();
  put(lines);
  std::string text = with_header ? row.header() : "";
  for (std::size_t line = 0; line < lines; ++line) {
    put(line);
    text += row.csv();
  }
  return text;
}

void require_equal(log_reader& log, const std::vector<log_column>& columns,
                   const std::function<void()>& between) {
  require_equal_header(log, columns);
  const std::size_t lines = columns.empty() ? 0 : columns.front().size();
  std::size_t line = 0;
  for (; log.next(); ++line) {
    if (line == lines) log.fail(0, "another line", std::to_string(lines) + " lines");
    for (std::size_t at = 0; at < columns.size(); ++at) require_equal_cell(log, at, columns[at], line);
    if ((line + 1) % lines_between == 0 && between) between();
  }
  if (line != lines) log.fail(0, "the log ends", std::to_string(lines) + " lines");
}

}  // namespace example
