/// The columns of docs/guide/log.md, with their units and types.
#pragma once

#include <string_view>
#include <vector>

namespace example {

/// Suffix of the names of a group of columns.
enum class column_parts {
  none,     ///< t
  numbers,  ///< q1, q2, ...
  axes      ///< Fh_x, Fh_y, Fh_z
};

/// One column, or several with one name.
struct known_column {
  std::string_view name;                ///< Without the suffix, "q" for q1.
  column_parts parts;                   ///< Suffix.
  std::vector<std::string_view> units;  ///< The first is that of a log without units; "" for words.
  bool is_read;                         ///< True if replay reads it, which then allows no other unit.
};

/// The columns of this library's logs.
const std::vector<known_column>& known_columns();

/// The known column for a name such as "q1", or nullptr.
const known_column* find_known(std::string_view name);

}  // namespace example
