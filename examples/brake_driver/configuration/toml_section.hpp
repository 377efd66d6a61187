/// @file
/// A table of a TOML file whose every key is checked.
#pragma once

#include <passive_haptics/core/parameter_text.hpp>

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace example {

/// Keys are read into values that hold their defaults: a key that is not there changes nothing. What cannot
/// be read, and in finish() what nobody reads, is thrown as std::invalid_argument that names file, line,
/// key, value and expectation.
class toml_section {
 public:
  /// The whole of a file. Throws std::invalid_argument where it is no regular file, over 1 MiB or no TOML.
  /// The keys that it lists as `allow_large` may have values that no device has, see
  /// passive_haptics::for_each_suspicious().
  static toml_section file(const std::string& path);
  /// A file without any key.
  static toml_section nothing();

  /// meaning: what more the value is expected to be, ": 0 to 99".
  void read(std::string_view key, double& value, std::string_view meaning = {});
  void read(std::string_view key, int& value, std::string_view meaning = {});
  void read(std::string_view key, bool& value, std::string_view meaning = {});
  void read(std::string_view key, std::string& value);
  /// One of these words.
  void read(std::string_view key, std::string& value, const std::vector<std::string_view>& choices);
  /// As many numbers as there are values, or one number for all of them: for what each brake, joint, axis or
  /// channel has.
  void read(std::string_view key, double* values, std::size_t count, std::string_view meaning = {});
  /// Reads a whole number, or true or false.
  void read(std::string_view key, int* values, std::size_t count, std::string_view meaning = {});
  void read(std::string_view key, bool* values, std::size_t count, std::string_view meaning = {});
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
  void read_vector(std::string_view key, double* values, std::size_t count, std::string_view meaning = {});
  /// A key for each member of a struct of parameters (passive_haptics/core/parameters.hpp), those of a struct
  /// within it among them; then check().
  template <passive_haptics::Parameters P>
  void read_all(P& parameters) {
    passive_haptics::for_each_member(
        parameters, [&](const auto& described, auto& value) { read_member(described, value); });
    check(parameters);
  }
  /// Throws what is wrong with the parameters: a range, a rule, a value that no device has and whose key
  /// is not allowed. The key of a member is its name, unless `keys` has another one.
  template <passive_haptics::Parameters P>
  void check(const P& parameters, const std::map<std::string_view, std::string_view>& keys = {}) const {
    require(validate(parameters));
    passive_haptics::for_each_suspicious(parameters, [&](const auto& member, const std::string& error) {
      const auto other = keys.find(member.name);
      require_allowed(other == keys.end() ? member.name : other->second, error);
    });
  }
  /// Rows of pairs, as [[0, 0], [0.5, 0.4]]; how many there are, at most `max_pairs`.
  std::size_t read_pairs(std::string_view key, double* values, std::size_t max_pairs);

  /// The table [key]; an empty one if it is not there.
  toml_section section(std::string_view key);
  /// The tables [[key]].
  std::vector<toml_section> sections(std::string_view key);
  /// If the key is there, throws its value and what was expected.
  void refuse(std::string_view key, const std::string& expected) const;
  /// Whether the key is there.
  bool has(std::string_view key) const;

  /// Throws if a key, here or in a section, was not read.
  void finish() const;
  /// Throws what is wrong with this section, unless that is empty.
  void require(const std::string& error) const;

 private:
  struct state;
  static std::string meaning_of(const passive_haptics::member_description& described);
  explicit toml_section(std::shared_ptr<state> s);
  void read_allowed();
  void require_allowed(std::string_view key, const std::string& error) const;
  template <class T>
  void read_each(std::string_view key, T* values, std::size_t count, const char* kinds, const char* kind,
                 std::string_view meaning, bool one_for_all = true);
  // A point, a direction or an acceleration has components, not values of each axis.
  static bool is_vector(const passive_haptics::member_description& described) {
    const std::string_view unit = described.unit;
    return described.hard.is_direction || unit == "m" || unit == "m/s^2";
  }
  template <class V>
  void read_member(const passive_haptics::member_description& described, V& value) {
    if constexpr (passive_haptics::Parameters<V>) {
      read_all(value);
    } else if constexpr (std::is_enum_v<V>) {
      const auto words = passive_haptics::choices_of(described);
      std::string word(words[static_cast<std::size_t>(value)]);
      read(described.name, word, words);
      value = static_cast<V>(std::find(words.begin(), words.end(), word) - words.begin());
    } else if constexpr (std::is_unsigned_v<V> && !std::is_same_v<V, bool>) {
      int number = static_cast<int>(value);
      read(described.name, number);
      require(passive_haptics::check_value(described.name, number, described.unit,
                                           passive_haptics::range::at_least(0)));
      value = static_cast<V>(number);
    } else if constexpr (std::is_same_v<V, std::string>) {
      read(described.name, value);
    } else {
      if constexpr (requires(double* p) { p = value.data(); })
        if (is_vector(described)) return read_vector(described.name, value, meaning_of(described));
      read(described.name, value, meaning_of(described));
    }
  }

  std::shared_ptr<state> state_;
};

}  // namespace example
