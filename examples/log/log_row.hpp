/// A line of a log: values with names and units, as CSV or JSON.
#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace example {

/// Version of the format in docs/guide/log.md.
inline constexpr int log_version = 1;

/// A column: unit "1" for a number without unit, "" for a word.
struct column {
  std::string name, unit;
};

/// Fill it in the same order for each line; the first line defines the columns. Numbers are written as the
/// shortest text that reads back exactly; numbers that are not finite, and empty words, give an empty cell.
class log_row {
 public:
  /// Begins the next line.
  void start() { used_ = 0; }
  /// Makes the following cells empty, or ends that.
  void blank(bool on) { blank_ = on; }
  void put(std::string_view name, std::string_view unit, double value);
  void put(std::string_view name, std::string_view unit, std::int64_t value);
  void put(std::string_view name, std::string_view word);
  /// name1, name2, ... in unit_of(0), unit_of(1), ...
  template <class UnitOf, class Values>
    requires requires(const UnitOf& unit_of) { std::string_view(unit_of(std::size_t{0})); }
  void put(const std::string& name, const UnitOf& unit_of, const Values& values) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(values.size()); ++i)
      put_part(name, std::to_string(i + 1), unit_of(i), static_cast<double>(values.data()[i]));
  }
  /// Adds numbers with one unit.
  template <class Values>
    requires requires(const Values& values) { values.data(), values.size(); }
  void put(const std::string& name, const char* unit, const Values& values) {
    put(name, [&](std::size_t) { return unit; }, values);
  }
  /// name_x, name_y, ...
  template <class Values>
  void put_axes(const std::string& name, std::string_view unit, const Values& values) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(values.size()); ++i)
      put_part(name, axes[i], unit, static_cast<double>(values.data()[i]));
  }

  const std::vector<column>& columns() const { return columns_; }
  /// Lines above the first one: version, units, names.
  std::string header() const;
  /// The line with its end.
  const std::string& csv();
  /// {"t":0.5,"q1":1.2,"state":"active"}, without empty cells.
  const std::string& json();

 private:
  static constexpr const char* axes[] = {"_x", "_y", "_z"};
  struct cell {
    std::string text;
    bool is_word = false;
  };

  void put_part(const std::string& name, const std::string& part, std::string_view unit, double value);
  cell& next(std::string_view name, std::string_view unit);

  std::vector<column> columns_;
  std::vector<cell> cells_;
  std::size_t used_ = 0;
  bool blank_ = false;
  std::string line_;
};

}  // namespace example
