/// @file
/// The bytes of a mesh file, read from front to back, and errors that say where in it.
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/scene/files/file_bytes.hpp>
#include <passive_haptics/scene/files/polygons.hpp>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace passive_haptics::detail {

/// Throws std::invalid_argument that names the file.
[[noreturn]] inline void fail_mesh_file(const std::filesystem::path& path, const std::string& error) {
  require_no_error(std::string("mesh file ").append(path.string()).append(": ").append(printable(error)));
  std::abort();
}

/// Words and values of a file, in order. What is not there or is no such value ends with an error that names
/// the file, the line of a text or the byte of binary data, what stands there and what was expected.
class mesh_source {
 public:
  /// Reads the whole file.
  explicit mesh_source(std::filesystem::path path) : path_(std::move(path)) {
    if (const std::string error = read_file(path_, bytes_); !error.empty()) fail_mesh_file(path_, error);
  }

  // ---- text

  /// The next word of this line; empty at its end. A backslash joins the next line to it.
  std::string_view word_in_line() {
    while (at_ < bytes_.size() && (is_blank(bytes_[at_]) || line_goes_on())) ++at_;
    const std::size_t from = at_;
    while (at_ < bytes_.size() && !is_blank(bytes_[at_]) && bytes_[at_] != '\n') ++at_;
    return std::string_view(bytes_).substr(from, at_ - from);
  }
  /// The next word, in whatever line; empty at the end of the file.
  std::string_view word() {
    for (;;) {
      if (const std::string_view found = word_in_line(); !found.empty() || at_ == bytes_.size()) return found;
      next_line();
    }
  }
  /// Goes to the begin of the next line, or to the end of the file.
  void next_line() {
    at_ = std::min(bytes_.find('\n', at_), bytes_.size());
    if (at_ == bytes_.size()) return;
    ++at_;
    ++line_;
  }
  /// A word that stands for a number: the whole of it.
  template <class T>
  T number(std::string_view text, const char* expected) const {
    T value{};
    const char* const end = text.data() + text.size();
    const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-';  // from_chars takes none
    const auto [stop, error] = std::from_chars(text.data() + (plus ? 1 : 0), end, value);
    if (error != std::errc() || stop != end) fail(text, expected);
    return value;
  }
  /// Ends with an error about the word that was read last.
  [[noreturn]] void fail(std::string_view found, std::string_view expected) const {
    constexpr std::size_t max_length = 40;  // characters
    const std::string text = found.empty()
                                 ? std::string(at_ == bytes_.size() ? "the file ends" : "the line ends")
                                 : std::string("'")
                                       .append(found.substr(0, max_length))
                                       .append(found.size() > max_length ? "...'" : "'");
    fail_mesh_file(path_, indexed("line ", line_, ": ").append(text).append(", expected ").append(expected));
  }

  // ---- binary data

  /// The next value, whose bytes stand in this order.
  template <class T>
  T value(std::endian order) {
    char raw[sizeof(T)];
    if (left() < sizeof(T)) fail_here("the file ends", "more data; it was cut off");
    for (std::size_t i = 0; i < sizeof(T); ++i)
      raw[order == std::endian::native ? i : sizeof(T) - 1 - i] = bytes_[at_ + i];
    at_ += sizeof(T);
    T read;
    std::memcpy(&read, raw, sizeof(T));
    return read;
  }
  /// Goes on to this byte.
  void seek(std::size_t byte) { at_ = byte; }
  /// Bytes that were not read yet.
  std::size_t left() const { return bytes_.size() - at_; }
  /// Ends with an error about the byte that comes next.
  [[noreturn]] void fail_here(std::string_view found, std::string_view expected) const {
    fail_mesh_file(path_, indexed("byte ", at_, ": ").append(found).append(", expected ").append(expected));
  }

  /// All of it.
  std::string_view bytes() const { return bytes_; }
  /// Its name.
  const std::filesystem::path& path() const { return path_; }

 private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }
  // Over the backslash, and to the end of the line that it hides
  bool line_goes_on() {
    if (bytes_[at_] != '\\') return false;
    const std::size_t end = bytes_.find_first_not_of('\r', at_ + 1);
    if (end == bytes_.npos || bytes_[end] != '\n') return false;
    at_ = end;
    ++line_;
    return true;
  }

  std::filesystem::path path_;
  std::string bytes_;
  std::size_t at_ = 0, line_ = 1;
};

/// The mesh of a file whose polygons `read(path, polygons)` adds.
inline mesh_file read_mesh_file(const std::filesystem::path& path, double metres_per_unit,
                                void (&read)(const std::filesystem::path&, polygons&)) {
  const auto refuse = [&](const std::string& error) {
    if (!error.empty()) fail_mesh_file(path, error);
  };
  refuse(check_value("metres_per_unit", metres_per_unit, "", range::positive));
  polygons found;
  read(path, found);
  mesh_file file;
  refuse(to_mesh(std::move(found), metres_per_unit, file));
  return file;
}

}  // namespace passive_haptics::detail
