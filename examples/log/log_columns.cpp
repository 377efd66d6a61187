#include <log/known_columns.hpp>
#include <log/log_columns.hpp>

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

}  // namespace example
