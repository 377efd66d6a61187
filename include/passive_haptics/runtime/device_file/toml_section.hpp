/// @file
/// A table of a TOML file whose every key is checked.
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

/// Keys are read into values that hold their defaults: a key that is not there changes nothing. What cannot
/// be read, and in finish() what nobody reads, is thrown as std::invalid_argument that names file, line,
/// key, value and expectation; tables of a list are numbered from 0. Several readers may read one section: a
/// key that one of them reads is known.
class toml_section {
  using kind = toml_value::kind;

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
    whole.state_->root = std::make_shared<const toml_value>(parse_toml(name, toml));
    whole.state_->table = whole.state_->root.get();
    whole.read_allowed();
    return whole;
  }
  /// A file without any key.
  static toml_section nothing() { return text("built-in configuration", ""); }

  /// A number, a whole number, or true or false. meaning: what more the value is expected to be, ": 0 to 99".
  template <class T>
    requires std::same_as<T, double> || std::same_as<T, int> || std::same_as<T, bool>
  void read(std::string_view key, T& value, std::string_view meaning = {}) {
    read_each(key, &value, 1, meaning);
  }
  /// A text without control characters.
  void read(std::string_view key, std::string& value) {
    const toml_value* found = state_->find(key);
    if (found == nullptr) return;
    if (found->type != kind::text) state_->expected(key, *found, "a text in quotes");
    const auto is_control = [](char c) { return std::iscntrl(static_cast<unsigned char>(c)) != 0; };
    if (std::ranges::any_of(found->text, is_control))
      state_->expected(key, *found, "a text without control characters");
    value = found->text;
  }
  /// One of these words; reason: why these.
  void read(std::string_view key, std::string& value, const std::vector<std::string_view>& choices,
            std::string_view reason = {}) {
    read(key, value);
    if (std::find(choices.begin(), choices.end(), value) != choices.end()) return;
    const std::string all = one_of(choices).append(reason).append(did_you_mean(value, choices));
    const toml_value* found = state_->find(key);
    if (found == nullptr)
      state_->fail(state_->table, state_->named(key).append(" is missing, expected ").append(all));
    state_->expected(key, *found, all);
  }
  /// As many as there are values, or one for all of them: for what each brake, joint, axis or channel has.
  template <class T>
  void read(std::string_view key, T* values, std::size_t count, std::string_view meaning = {}) {
    read_each(key, values, count, meaning);
  }
  /// Likewise those of a vector or an array.
  template <class Values>
    requires requires(Values& v) { v.data(), v.size(); }
  void read(std::string_view key, Values& values, std::string_view meaning = {}) {
    read_each(key, values.data(), static_cast<std::size_t>(values.size()), meaning);
  }
  /// As many numbers as there are values: for a point, a direction or a row of a matrix.
  template <class Values>
  void read_vector(std::string_view key, Values& values, std::string_view meaning = {}) {
    read_vector(key, values.data(), static_cast<std::size_t>(values.size()), meaning);
  }
  /// Likewise.
  void read_vector(std::string_view key, double* values, std::size_t count, std::string_view meaning = {}) {
    read_each(key, values, count, meaning, false);
  }
  /// Rows of pairs, as [[0, 0], [0.5, 0.4]]; how many there are, at most `max_pairs`.
  std::size_t read_pairs(std::string_view key, double* values, std::size_t max_pairs) {
    const toml_value* found = state_->find(key);
    if (found == nullptr) return 0;
    const std::string what = "pairs of numbers, at most " + std::to_string(max_pairs) + " of them";
    if (found->type != kind::list || found->items.size() > max_pairs) state_->expected(key, *found, what);
    read_rows(key, *found, what, values, 2, 2, 1);
    return found->items.size();
  }
  /// A key for each field, by its name; of a list of structs, a table [[key]] for each. check() is the
  /// caller's.
  void read_fields(const field_list& fields) {
    for (const field& f : fields) read_field(f);
  }
  /// A key for each member of a struct of parameters (passive_haptics/core/parameters.hpp), those of a struct
  /// within it among them; then check().
  template <Parameters P>
  void read_all(P& parameters) {
    field_list fields;
    add_fields(fields, parameters);
    read_fields(fields);
    // First by themselves: keys lack the name of the struct within
    for_each_member(parameters, [&]<class V>(const auto&, const V& value) {
      if constexpr (Parameters<V>) check(value);
    });
    check(parameters);
  }
  /// Likewise those that are known at run time only.
  void read_all(any_parameters& parameters) {
    read_fields(parameters.fields());
    require(parameters.error());
    parameters.for_each_suspicious(
        [&](const char* key, const std::string& error) { require_allowed(key, error); });
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
  /// The table [key]; an empty one if it is not there. form: what is expected of a value that is no table,
  /// unless it is "a table, [key]".
  toml_section section(std::string_view key, const std::string& form = {}) {
    const toml_value* found = state_->find(key);
    if (found != nullptr && found->type != kind::table)
      state_->expected(key, *found, form.empty() ? "a table, [" + state_->named(key) + "]" : form);
    return toml_section(state_->within(state_->named(key), found));
  }
  /// The tables [[key]]; none of `key = []`.
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
  /// If the key is there, throws its value and what was expected.
  void refuse(std::string_view key, const std::string& expected) const {
    if (const toml_value* found = state_->find(key)) state_->expected(key, *found, expected);
  }
  /// True if the section has this key.
  bool has(std::string_view key) const {
    return state_->table != nullptr && state_->table->find(key) != nullptr;
  }
  /// A key that another program reads, with all that is in it.
  void pass_over(std::string_view key) {
    if (state_->find(key) != nullptr) state_->allowed->all_are_read = false;
  }
  /// All keys of this section that are not read: those of another program.
  void pass_over_others() {
    if (state_->table == nullptr) return;
    for (const toml_value& one : state_->table->items) pass_over(one.key);
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
    state_->fail(state_->table == nullptr ? nullptr : detail::value_of_error(*state_->table, error),
                 (state_->name.empty() ? "" : "[" + state_->name + "] ") + error);
  }

 private:
  struct allowed_keys {
    std::map<std::string, bool, std::less<>> was_large;  // by key: whether a value needed it
    bool all_are_read = true;                            // else another program may need the others
  };

  // Of a section, shared by its readers.
  struct state {
    std::string file, name;  // name: "brakes" or "walls[0]"
    std::shared_ptr<allowed_keys> allowed;
    std::shared_ptr<const toml_value> root;
    const toml_value* table = nullptr;  // within root; none if the section is not there
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
      fail(&at, detail::beginning_of(named(key)) + " = " + detail::beginning_of(to_text(at)) + ", expected " +
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
  // Rows of numbers, the first ones `next` apart, those of a row `stride`.
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
