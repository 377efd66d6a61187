/// @file
/// The columns of docs/guide/log.md: their units, and which of them are words.
#pragma once

#include <string_view>
#include <vector>

namespace example {

/// What stands behind the name of a column that is one of several.
enum class column_parts {
  none,     ///< t
  numbers,  ///< q1, q2, ...
  axes      ///< Fh_x, Fh_y, Fh_z
};

/// A column, or several of one name.
struct known_column {
  std::string_view name;                ///< Without its part, as "q" of q1.
  column_parts parts;                   ///< What stands behind the name.
  std::vector<std::string_view> units;  ///< The first is that of a log without units; "" of words.
  bool is_read;                         ///< By replay, so that no other unit will do.
};

/// The columns of this library's logs.
const std::vector<known_column>& known_columns();

/// What is known of a column by its name, "q1", or nullptr.
const known_column* find_known(std::string_view name);

}  // namespace example
