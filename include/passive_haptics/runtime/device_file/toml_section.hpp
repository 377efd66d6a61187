/// A table of a TOML file with all keys checked.
#pragma once

#include <passive_haptics/core/parameter_text.hpp>
#include <passive_haptics/runtime/any_parameters.hpp>
#include <passive_haptics/runtime/device_file/nearest_name.hpp>
#include <passive_haptics/runtime/device_file/toml_value.hpp>
#include <passive_haptics/scene/files/file_bytes.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace passive_haptics::runtime {

/// Keys are read into values with defaults; a missing key changes nothing. A value that cannot be read, and
/// in finish() a key that nobody read, throws std::invalid_argument with file, line, key, value and
/// expectation.
class toml_section {
  using kind = toml_value::kind;

 public:
  /// Reads a file. Throws std::invalid_argument unless it is a regular TOML file of up to 1 MiB. The keys
  /// listed as `allow_large` may have implausible values, see passive_haptics::for_each_suspicious().
  static toml_section file(const std::string& path) {
    constexpr std::uintmax_t max_bytes = 1 << 20;
    std::string text;
    if (const auto error = read_file(path, text, max_bytes); !error.empty())
      throw std::invalid_argument(detail::printable(path + ": " + error));
    return toml_section::text(path, text);
  }
  /// Reads a text as that of a file of this name.
  static toml_section text(const std::string& name, const std::string& toml) {
    toml_section whole(std::make_shared<state>());
    whole.state_->file = name;
    whole.state_->allowed = std::make_shared<allowed_keys>();
    whole.state_->root = std::make_shared<const toml_value>(parse_toml(name, toml));
    whole.state_->table = whole.state_->root.get();
    whole.read_allowed();
    return whole;
  }
  /// A file without keys.
  static toml_section nothing() { return text("built-in configuration", ""); }

  /// Reads a number, a whole number, or true or false. meaning: more about the expected value, ": 0 to 99".
  template <class T>
    requires std::same_as<T, double> || std::same_as<T, int> || std::same_as<T, bool>
  void read(std::string_view key, T& value, std::string_view meaning = {}) {
    read_each(key, &value, 1, meaning);
  }
  /// Reads a text without control characters.
  void read(std::string_view key, std::string& value) {
    const toml_value* found = state_->find(key);
    if (found == nullptr) return;
    if (found->type != kind::text) state_->expected(key, *found, "a text in quotes");
    const auto is_control = [](char c) { return std::iscntrl(static_cast<unsigned char>(c)) != 0; };
    if (std::ranges::any_of(found->text, is_control))
      state_->expected(key, *found, "a text without control characters");
    value = found->text;
  }
  /// Reads one of these words; reason: explanation of the choices.
  void read(std::string_view key, std::string& value, const std::vector<std::string_view>& choices,
            std::string_view reason = {}) {
    read(key, value);
    if (std::find(choices.begin(), choices.end(), value) != choices.end()) return;
    const std::string all = one_of(choices).append(reason).append(did_you_mean(value, choices));
    const toml_value* found = state_->find(key);
    if (found == nullptr)
      state_->fail(state_->table, state_->named(key).append(" is missing: expected ").append(all));
    state_->expected(key, *found, all);
  }
  /// Reads one value per element, or one for all: for brakes, joints, axes or channels.
  template <class T>
  void read(std::string_view key, T* values, std::size_t count, std::string_view meaning = {}) {
    read_each(key, values, count, meaning);
  }
  /// Overload for a vector or an array.
  template <class Values>
    requires requires(Values& v) { v.data(), v.size(); }
  void read(std::string_view key, Values& values, std::string_view meaning = {}) {
    read_each(key, values.data(), static_cast<std::size_t>(values.size()), meaning);
  }
  /// Reads one number per element: for a point, a direction or a row of a matrix.
  template <class Values>
  void read_vector(std::string_view key, Values& values, std::string_view meaning = {}) {
    read_vector(key, values.data(), static_cast<std::size_t>(values.size()), meaning);
  }
  /// Overload for an array.
  void read_vector(std::string_view key, double* values, std::size_t count, std::string_view meaning = {}) {
    read_each(key, values, count, meaning, false);
  }
  /// Reads rows of pairs, as [[0, 0], [0.5, 0.4]]; returns their number, at most `max_pairs`.
  std::size_t read_pairs(std::string_view key, double* values, std::size_t max_pairs) {
    const toml_value* found = state_->find(key);
    if (found == nullptr) return 0;
    const std::string what = "pairs of numbers, at most " + std::to_string(max_pairs) + " of them";
    if (found->type != kind::list || found->items.size() > max_pairs) state_->expected(key, *found, what);
    read_rows(key, *found, what, values, 2, 2, 1);
    return found->items.size();
  }
  /// Reads a key for each field; for a list of structs a table [[key]] each. Does not check().
  void read_fields(const field_list& fields) {
    for (const field& f : fields) read_field(f);
  }
  /// Reads a key for each member of a parameter struct, including nested members, then calls check().
  template <Parameters P>
  void read_all(P& parameters) {
    field_list fields;
    add_fields(fields, parameters);
    read_fields(fields);
    // Nested structs first: keys lack their name
    for_each_member(parameters, [&]<class V>(const auto&, const V& value) {
      if constexpr (Parameters<V>) check(value);
    });
    check(parameters);
  }
  /// Overload for parameters chosen at run time.
  void read_all(any_parameters& parameters) {
    read_fields(parameters.fields());
    require(parameters.error());
    parameters.for_each_suspicious(
        [&](const char* key, const std::string& error) { require_allowed(key, error); });
  }
  /// Throws the error of a range, a rule, or an implausible value with a key that is not allowed. The key of
  /// a member is its name, unless `keys` has another one.
  template <Parameters P>
  void check(const P& parameters, const std::map<std::string_view, std::string_view>& keys = {}) const {
    require(validate(parameters));
    for_each_suspicious(parameters, [&](const auto& member, const std::string& error) {
      const auto other = keys.find(member.name);
      require_allowed(other == keys.end() ? member.name : other->second, error);
    });
  }
  /// The table [key], empty if missing. form: expectation in errors, by default "a table, [key]".
  toml_section section(std::string_view key, const std::string& form = {}) {
    const toml_value* found = state_->find(key);
    if (found != nullptr && found->type != kind::table)
      state_->expected(key, *found, form.empty() ? "a table, [" + state_->named(key) + "]" : form);
    return toml_section(state_->within(state_->named(key), found));
  }
  /// The tables [[key]]; empty for `key = []`.
  std::vector<toml_section> sections(std::string_view key) {
    std::vector<toml_section> all;
    const toml_value* found = state_->find(key);
    if (found == nullptr) return all;
    if (!found->is_list_of_tables())
      state_->expected(key, *found, "tables, [[" + state_->named(key) + "]] each");
    for (const toml_value& one : found->items)
      all.push_back(toml_section(state_->within(
          state_->named(key).append("[").append(std::to_string(all.size())).append("]"), &one)));
    return all;
  }
  /// If the key exists, throws its value and this expectation.
  void refuse(std::string_view key, const std::string& expected) const {
    if (const toml_value* found = state_->find(key)) state_->expected(key, *found, expected);
  }
  /// True if the section has this key.
  bool has(std::string_view key) const {
    return state_->table != nullptr && state_->table->find(key) != nullptr;
  }
  /// Skips a key of another program, with its content.
  void pass_over(std::string_view key) {
    if (state_->find(key) != nullptr) state_->allowed->all_are_read = false;
  }
  /// Skips all unread keys of this section.
  void pass_over_others() {
    if (state_->table == nullptr) return;
    for (const toml_value& one : state_->table->items) pass_over(one.key);
  }
  /// Registers an old name of a key, for the message of finish().
  void rename(std::string_view old_key, std::string now) {
    state_->renamed.insert_or_assign(std::string(old_key), std::move(now));
  }
  /// A path relative to the directory of the file.
  std::string beside(const std::string& path) const {
    return (std::filesystem::path(state_->file).parent_path() / path).string();
  }

  /// Throws if a key of this section or a nested one was not read.
  void finish() const;
  /// Throws a non-empty error of this section, with the line of the key in it.
  void require(const std::string& error) const {
    if (error.empty()) return;
    state_->fail(state_->table == nullptr ? nullptr : detail::value_of_error(*state_->table, error),
                 (state_->name.empty() ? "" : "[" + state_->name + "] ") + error);
  }

 private:
  struct allowed_keys {
    std::map<std::string, bool, std::less<>> was_large;  // by key: true if a value needed it
    bool all_are_read = true;                            // false if another program may need the others
  };

  struct state {
    std::string file, name;  // name: "brakes" or "walls[0]"
    std::shared_ptr<allowed_keys> allowed;
    std::shared_ptr<const toml_value> root;
    const toml_value* table = nullptr;  // within root; null if the section is missing
    std::set<std::string, std::less<>> known;
    std::map<std::string, std::string, std::less<>> renamed;
    std::vector<std::shared_ptr<state>> inner;

    [[noreturn]] void fail(const toml_value* at, const std::string& text) const {
      std::string message = file;
      if (at != nullptr && at->line > 0) message.append(":").append(std::to_string(at->line));
      throw std::invalid_argument(detail::printable(message.append(": ").append(text)));
    }
    std::string named(std::string_view key) const {
      return name.empty() ? std::string(key) : std::string(name).append(".").append(key);
    }
    [[noreturn]] void expected(std::string_view key, const toml_value& at, const std::string& what) const {
      fail(&at, detail::beginning_of(named(key)) + " = " + detail::beginning_of(to_text(at)) + ": expected " +
                    what);
    }
    const toml_value* find(std::string_view key) {
      known.emplace(key);
      return table == nullptr ? nullptr : table->find(key);
    }
    std::shared_ptr<state> within(std::string inner_name, const toml_value* inner_table) {
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

  void require_allowed(std::string_view key, const std::string& error) const {
    const auto name = state_->allowed->was_large.find(key);
    if (name != state_->allowed->was_large.end()) name->second = true;
    else require(std::string(error).append("; if it is meant, allow_large = [\"").append(key).append("\"]"));
  }
  void read_allowed();
  void read_field(const field& f);

  static bool is_read(const toml_value& from, double& to) {
    to = from.number;
    return from.type == kind::number || from.type == kind::whole;
  }
  static bool is_read(const toml_value& from, int& to) {
    to = static_cast<int>(from.whole);
    return from.type == kind::whole && std::in_range<int>(from.whole);
  }
  static bool is_read(const toml_value& from, bool& to) {
    to = from.whole != 0;
    return from.type == kind::truth;
  }
  // Rows of numbers; `next` between rows, `stride` within a row.
  void read_rows(std::string_view key, const toml_value& list, const std::string& what, double* values,
                 std::size_t count, std::size_t next, std::size_t stride) {
    for (const toml_value& row : list.items) {
      if (row.type != kind::list || row.items.size() != count) state_->expected(key, list, what);
      for (std::size_t i = 0; i < count; ++i)
        if (!is_read(row.items[i], values[i * stride])) state_->expected(key, list, what);
      values += next;
    }
  }
  template <class T>
  void read_each(std::string_view key, T* values, std::size_t count, std::string_view meaning,
                 bool one_for_all = true);

  std::shared_ptr<state> state_;
};

template <class T>
void toml_section::read_each(std::string_view key, T* values, std::size_t count, std::string_view meaning,
                             bool one_for_all) {
  const toml_value* found = state_->find(key);
  if (found == nullptr) return;
  constexpr std::array words = std::same_as<T, bool>  ? std::array{"true or false", " times true or false"}
                               : std::same_as<T, int> ? std::array{"a whole number", " whole numbers"}
                                                      : std::array{"a number", " numbers"};
  std::string what = count == 1 ? words[0] : std::to_string(count) + words[1];
  if (count != 1 && one_for_all) what.append(", or one for all");
  what.append(meaning);
  const bool is_list = found->type == kind::list;
  if (is_list ? found->items.size() != count : count != 1 && !one_for_all)
    state_->expected(key, *found, what);
  for (std::size_t i = 0; i < count; ++i)
    if (!is_read(is_list ? found->items[i] : *found, values[i])) state_->expected(key, *found, what);
}

}  // namespace passive_haptics::runtime
