/// @file
/// A table of a TOML file whose every key is checked.
#pragma once

#include <passive_haptics/core/parameter_text.hpp>
#include <passive_haptics/runtime/any_parameters.hpp>
#include <passive_haptics/runtime/device_file/nearest_name.hpp>
#include <passive_haptics/runtime/device_file/toml_nodes.hpp>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace passive_haptics::runtime {

/// Keys are read into values that hold their defaults: a key that is not there changes nothing. What cannot
/// be read, and in finish() what nobody reads, is thrown as std::invalid_argument that names file, line,
/// key, value and expectation. Several readers may read one section: a key that one of them reads is known.
class toml_section {
 public:
  /// The whole of a file. Throws std::invalid_argument where it is no regular file, over 1 MiB or no TOML.
  /// The keys that it lists as `allow_large` may have values that no device has, see
  /// passive_haptics::for_each_suspicious().
  static toml_section file(const std::string& path) {
    constexpr std::uintmax_t max_bytes = 1 << 20;
    std::string text;
    if (const auto error = read_file(path, text, max_bytes); !error.empty())
      throw std::invalid_argument(detail::printable(path + ": " + error));
    return toml_section::text(path, text);
  }
  /// The whole of a text, as that of a file of this name.
  static toml_section text(const std::string& name, const std::string& toml) {
    toml_section whole(std::make_shared<state>());
    whole.state_->file = name;
    whole.state_->allowed = std::make_shared<allowed_keys>();
    whole.state_->root = std::make_shared<const toml::table>(detail::parsed_toml(name, toml));
    whole.state_->table = whole.state_->root.get();
    whole.read_allowed();
    return whole;
  }
  /// A file without any key.
  static toml_section nothing() { return text("built-in configuration", ""); }

  /// meaning: what more the value is expected to be, ": 0 to 99".
  void read(std::string_view key, double& value, std::string_view meaning = {}) {
    read(key, &value, 1, meaning);
  }
  /// Likewise a whole number.
  void read(std::string_view key, int& value, std::string_view meaning = {}) {
    read(key, &value, 1, meaning);
  }
  /// Likewise true or false.
  void read(std::string_view key, bool& value, std::string_view meaning = {}) {
    read(key, &value, 1, meaning);
  }
  /// A text without control characters.
  void read(std::string_view key, std::string& value) {
    const toml::node* node = state_->find(key);
    if (node == nullptr) return;
    const auto text = node->value_exact<std::string>();
    const auto is_control = [](char c) { return std::iscntrl(static_cast<unsigned char>(c)) != 0; };
    if (!text) state_->expected(key, *node, "a text in quotes");
    if (std::any_of(text->begin(), text->end(), is_control))
      state_->expected(key, *node, "a text without control characters");
    value = *text;
  }
  /// One of these words; reason: why these.
  void read(std::string_view key, std::string& value, const std::vector<std::string_view>& choices,
            std::string_view reason = {}) {
    read(key, value);
    if (std::find(choices.begin(), choices.end(), value) != choices.end()) return;
    const std::string all = one_of(choices).append(reason).append(did_you_mean(value, choices));
    const toml::node* node = state_->find(key);
    if (node == nullptr)
      state_->fail(state_->table, state_->named(key).append(" is missing, expected ").append(all));
    state_->expected(key, *node, all);
  }
  /// As many numbers as there are values, or one number for all of them: for what each brake, joint, axis or
  /// channel has.
  void read(std::string_view key, double* values, std::size_t count, std::string_view meaning = {}) {
    read_each(key, values, count, "numbers", "a number", meaning);
  }
  /// Reads a whole number, or true or false.
  void read(std::string_view key, int* values, std::size_t count, std::string_view meaning = {}) {
    read_each(key, values, count, "whole numbers", "a whole number", meaning);
  }
  /// Likewise true or false.
  void read(std::string_view key, bool* values, std::size_t count, std::string_view meaning = {}) {
    read_each(key, values, count, "times true or false", "true or false", meaning);
  }
  /// Likewise those of a vector or an array.
  template <class Values>
    requires requires(Values& v) { v.data(), v.size(); }
  void read(std::string_view key, Values& values, std::string_view meaning = {}) {
    read(key, values.data(), static_cast<std::size_t>(values.size()), meaning);
  }
  /// As many numbers as there are values: for a point, a direction or a row of a matrix.
  template <class Values>
  void read_vector(std::string_view key, Values& values, std::string_view meaning = {}) {
    read_vector(key, values.data(), static_cast<std::size_t>(values.size()), meaning);
  }
  /// Likewise.
  void read_vector(std::string_view key, double* values, std::size_t count, std::string_view meaning = {}) {
    read_each(key, values, count, "numbers", "a number", meaning, false);
  }
  /// Rows of pairs, as [[0, 0], [0.5, 0.4]]; how many there are, at most `max_pairs`.
  std::size_t read_pairs(std::string_view key, double* values, std::size_t max_pairs) {
    const toml::node* node = state_->find(key);
    if (node == nullptr) return 0;
    const std::string what = "pairs of numbers, at most " + std::to_string(max_pairs) + " of them";
    const toml::array* list = node->as_array();
    if (list == nullptr || list->size() > max_pairs) state_->expected(key, *node, what);
    for (std::size_t i = 0; i < list->size(); ++i) read_row(key, (*list)[i], 2, what, values + 2 * i);
    return list->size();
  }
  /// A key for each member of a struct of parameters (passive_haptics/core/parameters.hpp), those of a struct
  /// within it among them; then check().
  template <Parameters P>
  void read_all(P& parameters) {
    for_each_member(parameters, [&](const auto& described, auto& value) { read_member(described, value); });
    check(parameters);
  }
  /// Throws what is wrong with the parameters: a range, a rule, a value that no device has and whose key
  /// is not allowed. The key of a member is its name, unless `keys` has another one.
  template <Parameters P>
  void check(const P& parameters, const std::map<std::string_view, std::string_view>& keys = {}) const {
    require(validate(parameters));
    for_each_suspicious(parameters, [&](const auto& member, const std::string& error) {
      const auto other = keys.find(member.name);
      require_allowed(other == keys.end() ? member.name : other->second, error);
    });
  }
  /// A key for the field, by its name; of a list of structs, a table [[key]] for each. check() is the
  /// caller's.
  void read_field(const field& f);
  /// A key for each field; then what check() does.
  void read_all(any_parameters& parameters) {
    for (const field& f : parameters.fields()) read_field(f);
    require(parameters.error());
    parameters.for_each_suspicious(
        [&](const char* key, const std::string& error) { require_allowed(key, error); });
  }

  /// The table [key]; an empty one if it is not there. form: what is expected of a value that is no table,
  /// unless it is "a table, [key]".
  toml_section section(std::string_view key, const std::string& form = {}) {
    const toml::node* node = state_->find(key);
    if (node != nullptr && !node->is_table())
      state_->expected(key, *node, form.empty() ? "a table, [" + state_->named(key) + "]" : form);
    return toml_section(state_->within(state_->named(key), node == nullptr ? nullptr : node->as_table()));
  }
  /// The tables [[key]]; none of `key = []`.
  std::vector<toml_section> sections(std::string_view key) {
    std::vector<toml_section> all;
    const toml::node* node = state_->find(key);
    if (node == nullptr) return all;
    const toml::array* list = node->as_array();
    if (list == nullptr || !(list->empty() || list->is_array_of_tables()))
      state_->expected(key, *node, "tables, [[" + state_->named(key) + "]] each");
    for (const toml::node& one : *list)
      all.push_back(toml_section(
          state_->within(state_->named(key).append("[").append(std::to_string(all.size() + 1)).append("]"),
                         one.as_table())));
    return all;
  }
  /// If the key is there, throws its value and what was expected.
  void refuse(std::string_view key, const std::string& expected) const {
    if (const toml::node* node = state_->find(key); node != nullptr) state_->expected(key, *node, expected);
  }
  /// True if the section has this key.
  bool has(std::string_view key) const { return state_->table != nullptr && state_->table->contains(key); }
  /// A key that another program reads, with all that is in it.
  void pass_over(std::string_view key) {
    if (state_->find(key) != nullptr) state_->allowed->all_are_read = false;
  }
  /// All keys of this section that are not read: those of another program.
  void pass_over_others() {
    if (state_->table == nullptr) return;
    for (const auto& [key, node] : *state_->table) pass_over(key.str());
  }
  /// An old name of a key: where nobody reads it, finish() reports that this is expected.
  void rename(std::string_view old_key, std::string now) {
    state_->renamed.insert_or_assign(std::string(old_key), std::move(now));
  }
  /// A path as the file means it: from the directory that the file is in.
  std::string beside(const std::string& path) const {
    return (std::filesystem::path(state_->file).parent_path() / path).string();
  }

  /// Throws if a key, here or in a section, was not read.
  void finish() const;
  /// Throws what is wrong with this section, unless that is empty; with the line of the key that the error
  /// names.
  void require(const std::string& error) const {
    if (error.empty()) return;
    state_->fail(state_->table == nullptr ? nullptr : detail::node_of_error(*state_->table, error),
                 (state_->name.empty() ? "" : "[" + state_->name + "] ") + error);
  }

 private:
  struct allowed_keys {
    std::map<std::string, bool, std::less<>> was_large;  // by key: whether a value needed it
    bool all_are_read = true;                            // else another program may need the others
  };

  // Of a section, shared by its readers.
  struct state {
    std::string file, name;  // name: "brakes" or "walls[1]"
    std::shared_ptr<allowed_keys> allowed;
    std::shared_ptr<const toml::table> root;
    const toml::table* table = nullptr;  // within root; none if the section is not there
    std::set<std::string, std::less<>> known;
    std::map<std::string, std::string, std::less<>> renamed;
    std::vector<std::shared_ptr<state>> inner;

    [[noreturn]] void fail(const toml::node* at, const std::string& text) const {
      std::string message = file;
      if (at != nullptr && at->source().begin.line > 0)
        message.append(":").append(std::to_string(at->source().begin.line));
      throw std::invalid_argument(detail::printable(message.append(": ").append(text)));
    }
    std::string named(std::string_view key) const {
      return name.empty() ? std::string(key) : std::string(name).append(".").append(key);
    }
    [[noreturn]] void expected(std::string_view key, const toml::node& at, const std::string& what) const {
      std::ostringstream value;
      detail::write_node(value, at);
      fail(&at, detail::beginning_of(named(key))
                    .append(" = ")
                    .append(detail::beginning_of(value.str()))
                    .append(", expected ")
                    .append(what));
    }
    const toml::node* find(std::string_view key) {
      known.emplace(key);
      return table == nullptr ? nullptr : table->get(key);
    }
    std::shared_ptr<state> within(std::string inner_name, const toml::table* inner_table) {
      for (const auto& one : inner)
        if (one->name == inner_name) return one;
      auto s = std::make_shared<state>();
      s->file = file;
      s->name = std::move(inner_name);
      s->root = root;
      s->allowed = allowed;
      s->table = inner_table;
      inner.push_back(s);
      return s;
    }
  };

  explicit toml_section(std::shared_ptr<state> s) : state_(std::move(s)) {}

  static std::string meaning_of(const member_description& described) {
    std::string text;
    if (described.hard.is_checked) text.append(": ").append(to_text(described.hard));
    if (*described.unit != '\0') text.append(" [").append(described.unit).append("]");
    return text;
  }
  // A point, a direction or an acceleration has components, not values of each axis.
  static bool is_vector(const member_description& described) {
    const std::string_view unit = described.unit;
    return described.hard.is_direction || unit == "m" || unit == "m/s^2";
  }

  void read_allowed();
  void require_allowed(std::string_view key, const std::string& error) const {
    const auto name = state_->allowed->was_large.find(key);
    if (name != state_->allowed->was_large.end()) name->second = true;
    else require(std::string(error).append("; if it is meant, allow_large = [\"").append(key).append("\"]"));
  }
  void read_row(std::string_view key, const toml::node& row, std::size_t count, const std::string& what,
                double* values, std::size_t stride = 1) {
    const toml::array* numbers = row.as_array();
    const toml::node& whole = *state_->find(key);
    if (numbers == nullptr || numbers->size() != count) state_->expected(key, whole, what);
    for (std::size_t i = 0; i < count; ++i) {
      const auto number = detail::number_of((*numbers)[i]);
      if (!number) state_->expected(key, whole, what);
      values[i * stride] = *number;
    }
  }
  template <class T>
  void read_each(std::string_view key, T* values, std::size_t count, const char* kinds, const char* kind,
                 std::string_view meaning, bool one_for_all = true);
  template <class V>
  void read_member(const member_description& described, V& value);

  std::shared_ptr<state> state_;
};

inline void toml_section::read_allowed() {
  const char* const key = "allow_large";
  const toml::node* node = state_->find(key);
  if (node == nullptr) return;
  const toml::array* list = node->as_array();
  if (list == nullptr) state_->expected(key, *node, "a list of keys in quotes");
  for (const toml::node& one : *list) {
    const auto name = one.value_exact<std::string>();
    if (!name) state_->expected(key, *node, "a list of keys in quotes");
    state_->allowed->was_large[*name] = false;
  }
}

template <class T>
void toml_section::read_each(std::string_view key, T* values, std::size_t count, const char* kinds,
                             const char* kind, std::string_view meaning, bool one_for_all) {
  const toml::node* node = state_->find(key);
  if (node == nullptr) return;
  const auto as = [](const toml::node& n, T& to) {
    if constexpr (std::is_same_v<T, double>) {
      const auto found = detail::number_of(n);
      if (!found) return false;
      to = *found;
    } else {
      const auto found = n.value_exact<std::conditional_t<std::is_same_v<T, bool>, bool, std::int64_t>>();
      if (!found || !std::in_range<int>(static_cast<std::int64_t>(*found))) return false;
      to = static_cast<T>(*found);
    }
    return true;
  };
  std::string what = kind;
  if (count != 1) what = std::to_string(count).append(" ").append(kinds);
  if (count != 1 && one_for_all) what.append(", or one for all");
  what.append(meaning);
  if (const toml::array* list = node->as_array()) {
    if (list->size() != count) state_->expected(key, *node, what);
    for (std::size_t i = 0; i < count; ++i)
      if (!as((*list)[i], values[i])) state_->expected(key, *node, what);
  } else {
    T one{};
    if (!(one_for_all || count == 1) || !as(*node, one)) state_->expected(key, *node, what);
    std::fill_n(values, count, one);
  }
}

template <class V>
void toml_section::read_member(const member_description& described, V& value) {
  if constexpr (Parameters<V>) {
    read_all(value);
  } else if constexpr (std::is_enum_v<V>) {
    const auto words = choices_of(described);
    std::string chosen(words[static_cast<std::size_t>(value)]);
    read(described.name, chosen, words);
    value = static_cast<V>(std::find(words.begin(), words.end(), chosen) - words.begin());
  } else if constexpr (std::is_unsigned_v<V> && !std::is_same_v<V, bool>) {
    int number = static_cast<int>(value);
    read(described.name, number);
    require(check_value(described.name, number, described.unit, range::at_least(0)));
    value = static_cast<V>(number);
  } else if constexpr (std::is_same_v<V, std::string>) {
    read(described.name, value);
  } else {
    if constexpr (requires(double* p) { p = value.data(); })
      if (is_vector(described)) return read_vector(described.name, value, meaning_of(described));
    read(described.name, value, meaning_of(described));
  }
}

inline void toml_section::read_field(const field& f) {
  using kind = field::kind;
  const char* const key = f.about.name;
  const auto count = static_cast<std::size_t>(f.count());
  if (f.type == kind::text) {
    read(key, f.text());
  } else if (f.type == kind::choice) {
    const auto words = choices_of(f.about);
    std::string chosen(words[static_cast<std::size_t>(f.get(f.at))]);
    read(key, chosen, words);
    f.set(f.at, static_cast<int>(std::find(words.begin(), words.end(), chosen) - words.begin()));
  } else if (f.type == kind::truth) {
    bool is = f.get(f.at) != 0;
    read(key, is);
    f.set(f.at, is ? 1 : 0);
  } else if (f.type == kind::whole) {
    int number = f.get(f.at);
    read(key, number, meaning_of(f.about));
    f.set(f.at, number);
  } else if (f.type == kind::tables) {
    auto given = sections(key);
    if (given.empty()) return;
    if (given.size() != f.tables.size())
      state_->expected(key, *state_->find(key),
                       std::to_string(f.tables.size()) + " tables, [[" + state_->named(key) + "]] each");
    for (std::size_t i = 0; i < given.size(); ++i)
      for (const field& inner : f.tables[i]) given[i].read_field(inner);
  } else if (f.type == kind::points) {
    const toml::node* node = state_->find(key);
    if (node == nullptr) return;
    const auto size = static_cast<std::size_t>(f.rows);
    const std::string what =
        "a list of points of " + std::to_string(size) + " numbers each" + meaning_of(f.about);
    const toml::array* list = node->as_array();
    if (list == nullptr || list->empty()) state_->expected(key, *node, what);
    double* const numbers = f.resize(f.at, list->size());
    for (std::size_t i = 0; i < list->size(); ++i) read_row(key, (*list)[i], size, what, numbers + i * size);
  } else if (f.columns > 1) {  // by rows, which are stored column by column
    const toml::node* node = state_->find(key);
    if (node == nullptr) return;
    const std::string what =
        std::to_string(f.rows) + " rows of " + std::to_string(f.columns) + " numbers" + meaning_of(f.about);
    const toml::array* rows = node->as_array();
    const auto row_count = static_cast<std::size_t>(f.rows);
    if (rows == nullptr || rows->size() != row_count) state_->expected(key, *node, what);
    for (std::size_t i = 0; i < row_count; ++i)
      read_row(key, (*rows)[i], static_cast<std::size_t>(f.columns), what, f.numbers() + i, row_count);
  } else if (is_vector(f.about)) {
    read_vector(key, f.numbers(), count, meaning_of(f.about));
  } else {
    read(key, f.numbers(), count, meaning_of(f.about));
  }
}

inline void toml_section::finish() const {
  if (state_->table != nullptr) {
    for (const auto& [key, node] : *state_->table) {
      if (state_->known.contains(key.str())) continue;
      if (const auto now = state_->renamed.find(key.str()); now != state_->renamed.end())
        state_->expected(key.str(), node, now->second + ": the key was renamed");
      std::string all;
      for (const std::string& one : state_->known) all.append(all.empty() ? "" : ", ").append(one);
      state_->fail(&node, "unknown key '" + detail::beginning_of(state_->named(key.str())) +
                              "', expected one of " + all + did_you_mean(key.str(), state_->known));
    }
  }
  for (const auto& inner : state_->inner) toml_section(inner).finish();
  if (!state_->name.empty() || !state_->allowed->all_are_read) return;
  for (const auto& [key, was_large] : state_->allowed->was_large)
    if (!was_large)
      require("allow_large = [\"" + detail::beginning_of(key) +
              "\"], expected keys of values that no device has; remove it");
}

}  // namespace passive_haptics::runtime
