/// Values of a TOML file with their lines.
#pragma once

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace passive_haptics::runtime {

/// A value of a TOML file, by default an empty table.
struct toml_value {
  /// Type of the value.
  enum class kind {
    table,   ///< Values with keys.
    list,    ///< Values without keys.
    text,    ///< Text in quotes.
    truth,   ///< true or false.
    whole,   ///< A whole number.
    number,  ///< Any other number.
    other,   ///< A date or a time.
  };
  kind type = kind::table;             ///< Type.
  int line = 0;                        ///< Line in the file, from 1; 0 if it is not in the file.
  std::string key = {};                ///< Key in its table.
  std::vector<toml_value> items = {};  ///< Elements of a table, sorted by key, or of a list.
  std::string text = {};               ///< Value of a text.
  std::string shown = {};              ///< Text in messages; to_text() for tables and lists.
  std::int64_t whole = 0;              ///< Value of a whole number; 1 for true.
  double number = 0;                   ///< Value of a number; nearest double of a whole number.

  /// The value of a key in a table; nullptr if missing.
  const toml_value* find(std::string_view name) const {
    const auto found = std::ranges::find(items, name, &toml_value::key);
    return type != kind::table || found == items.end() ? nullptr : &*found;
  }
  /// True for a list of tables, [[key]] each.
  bool is_list_of_tables() const {
    return type == kind::list &&
           std::ranges::all_of(items, [](kind k) { return k == kind::table; }, &toml_value::type);
  }
};

/// One line of text, "[ 1, a table ]".
inline std::string to_text(const toml_value& value) {
  if (value.type == toml_value::kind::table) return "a table";
  if (value.type != toml_value::kind::list) return value.shown;
  std::string all = "[";
  for (const toml_value& one : value.items) all.append(all.size() == 1 ? " " : ", ").append(to_text(one));
  return all.append(value.items.empty() ? "]" : " ]");
}

/// Parses a text; file: its name in messages. Throws std::invalid_argument with file and line if the text is
/// not TOML. Defined in parse_toml.hpp, which exactly one source of a program includes.
toml_value parse_toml(const std::string& file, const std::string& text);

}  // namespace passive_haptics::runtime

namespace passive_haptics::detail {

// The rest after the key in a text such as "joints[1].point[0] [m]"; empty if the key is not a word of it.
inline std::optional<std::string_view> behind_key(std::string_view name, std::string_view key) {
  const auto in_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  for (auto at = name.find(key); at != std::string_view::npos; at = name.find(key, at + 1)) {
    const auto end = at + key.size();
    if ((at == 0 || !in_word(name[at - 1])) && (end == name.size() || !in_word(name[end])))
      return name.substr(end);
  }
  return std::nullopt;
}

// The value of an error "NAME = VALUE: expected WHAT" about this table: that of the longest key in NAME, or,
// if a number of a table in a list follows, the value in that table. Without a key the table itself.
inline const runtime::toml_value* value_of_error(const runtime::toml_value& table, std::string_view error) {
  const std::string_view name = error.substr(0, std::min(error.find(" = "), error.find(": expected")));
  std::string_view rest;
  const runtime::toml_value* found = &table;
  std::size_t length = 0;
  for (const runtime::toml_value& one : table.items)
    if (const auto behind = behind_key(name, one.key); behind && one.key.size() > length) {
      found = &one;
      length = one.key.size();
      rest = *behind;
    }
  if (found == &table || !found->is_list_of_tables() || rest.size() < 2 || rest[0] != '[') return found;
  const auto i = static_cast<std::size_t>(rest[1] - '0');
  return i < std::min<std::size_t>(10, found->items.size()) ? value_of_error(found->items[i], rest) : found;
}

// Values and keys may be as long as their file.
inline std::string beginning_of(std::string text) {
  constexpr std::size_t max_length = 200;  // characters
  if (text.size() > max_length) text.replace(max_length, text.npos, "...");
  return text;
}

}  // namespace passive_haptics::detail
