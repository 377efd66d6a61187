/// @file
/// A table of a TOML file whose every key is checked.
#pragma once

#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace example {

/// Keys are read into values that hold their defaults: a key that is not there changes nothing. What cannot
/// be read, and in finish() what nobody asked for, is thrown as std::invalid_argument that names file, line,
/// key, value and expectation.
class toml_section {
 public:
  /// The whole of a file. Throws std::invalid_argument where it cannot be read or is no TOML.
  static toml_section file(const std::string& path);
  /// A file without any key.
  static toml_section nothing();

  void read(std::string_view key, double& value);
  void read(std::string_view key, int& value);
  void read(std::string_view key, bool& value);
  void read(std::string_view key, std::string& value);
  /// One of these words.
  void read(std::string_view key, std::string& value, std::initializer_list<std::string_view> choices);
  /// As many numbers as there are values, or one number for all of them.
  void read(std::string_view key, double* values, std::size_t count);
  /// The same of whole numbers and of true and false.
  void read(std::string_view key, int* values, std::size_t count);
  void read(std::string_view key, bool* values, std::size_t count);
  template <class Values>
    requires requires(Values& v) { v.data(), v.size(); }
  void read(std::string_view key, Values& values) {
    read(key, values.data(), static_cast<std::size_t>(values.size()));
  }
  /// Rows of pairs, as [[0, 0], [0.5, 0.4]]; how many there are, at most `most`.
  std::size_t read_pairs(std::string_view key, double* values, std::size_t most);

  /// The table [key]; an empty one if it is not there.
  toml_section section(std::string_view key);
  /// The tables [[key]].
  std::vector<toml_section> sections(std::string_view key);
  /// Whether the key is there.
  bool has(std::string_view key) const;

  /// Throws if a key, here or in a section, was not read.
  void finish() const;
  /// Throws what is wrong with this section, unless that is empty.
  void require(const std::string& error) const;

 private:
  struct state;
  explicit toml_section(std::shared_ptr<state> s);
  template <class T>
  void read_all(std::string_view key, T* values, std::size_t count, const char* kinds, const char* kind);

  std::shared_ptr<state> state_;
};

}  // namespace example
