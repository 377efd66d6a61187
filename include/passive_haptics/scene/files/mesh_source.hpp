/// Sequential reading of a mesh file, with errors that give the place in it.
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/scene/files/file_bytes.hpp>
#include <passive_haptics/scene/files/polygons.hpp>
#include <passive_haptics/scene/files/text_lines.hpp>

#include <bit>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace passive_haptics::detail {

/// Throws std::invalid_argument with the name of the file.
[[noreturn]] inline void fail_mesh_file(const std::filesystem::path& path, const std::string& error) {
  require_no_error(std::string("mesh file ").append(path.string()).append(": ").append(printable(error)));
  std::abort();
}

inline std::string quoted(std::string_view word) {
  constexpr std::size_t max_length = 40;  // characters
  return std::string("'").append(word.substr(0, max_length)).append(word.size() > max_length ? "...'" : "'");
}

/// The words and values of a file, in order. Errors give the file, the line or byte, and the expectation.
class mesh_source {
 public:
  /// Reads the whole file. With `joins_lines`, a backslash at the end of a line joins the next line to it.
  explicit mesh_source(std::filesystem::path path, bool joins_lines = false)
      : path_(std::move(path)), joins_lines_(joins_lines), lines_(read_or_fail(path_)) {}

  text_lines& lines() { return lines_; }
  /// The next word of this line; empty at its end.
  std::string_view word_in_line() {
    do {
      if (!in_line_) begin_line();
      while (at_ < line_end_ && is_blank(bytes()[at_])) ++at_;
    } while (at_ == line_end_ && goes_on_ && next_line());
    const std::size_t from = at_;
    while (at_ < line_end_ && !is_blank(bytes()[at_])) ++at_;
    return bytes().substr(from, at_ - from);
  }
  /// The next word, on any line; empty at the end of the file.
  std::string_view word() {
    for (;;) {
      if (const std::string_view found = word_in_line(); !found.empty() || lines_.is_last()) return found;
      next_line();
    }
  }
  /// Goes to the next line, or the end of the file. True if a backslash joins it to the line before.
  bool next_line() {
    if (!in_line_) begin_line();
    at_ = lines_.position();
    in_line_ = lines_.is_last();
    return std::exchange(goes_on_, false);
  }
  template <class T>
  T number(std::string_view text, const char* expected) const {
    T value{};
    const auto [stop, error] = read_number(text, value);
    if (error != std::errc() || stop != text.data() + text.size())
      fail(text, std::string(expected).append(cause_of_no_number(text, lines_.is_last())));
    return value;
  }
  /// The place of the last word, for a message: "line 7: 'Kd'".
  std::string place_of(std::string_view found) const {
    return indexed("line ", lines_.number(), ": ")
        .append(!found.empty()     ? quoted(found)
                : lines_.is_last() ? "the file ends"
                                   : "the line ends");
  }
  [[noreturn]] void fail(std::string_view found, std::string_view expected) const {
    fail_mesh_file(path_, place_of(found).append(": expected ").append(expected));
  }
  std::size_t line() const { return lines_.number(); }  ///< The line of the last word, from 1.

  /// The next value, in this byte order.
  template <class T>
  T value(std::endian order) {
    char raw[sizeof(T)];
    if (left() < sizeof(T)) fail_here("the file ends", "more data; it was cut off");
    for (std::size_t i = 0; i < sizeof(T); ++i)
      raw[order == std::endian::native ? i : sizeof(T) - 1 - i] = bytes()[at_ + i];
    at_ += sizeof(T);
    T read;
    std::memcpy(&read, raw, sizeof(T));
    return read;
  }
  void seek(std::size_t byte) { at_ = byte; }
  std::size_t byte() const { return at_; }                   ///< Offset of the next byte.
  std::size_t left() const { return bytes().size() - at_; }  ///< Number of unread bytes.
  bool only_padding_is_left() const {
    return bytes().find_first_not_of(text_lines::padding, at_) == std::string::npos;
  }
  /// Throws an error about the next byte.
  [[noreturn]] void fail_here(std::string_view found, std::string_view expected) const {
    fail_mesh_file(path_, indexed("byte ", at_, ": ").append(found).append(": expected ").append(expected));
  }

  std::string_view bytes() const { return lines_.bytes(); }
  const std::filesystem::path& path() const { return path_; }

 private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }
  static std::string read_or_fail(const std::filesystem::path& path) {
    std::string bytes;
    if (const std::string error = read_file(path, bytes); !error.empty()) fail_mesh_file(path, error);
    return bytes;
  }
  void begin_line() {
    if (!lines_.next() && !lines_.error().empty())
      fail_mesh_file(path_, indexed("line ", lines_.number(), ": ").append(lines_.error()));
    const std::string_view line = lines_.line();
    in_line_ = true;
    goes_on_ = joins_lines_ && line.ends_with('\\') && !lines_.is_last();
    at_ = static_cast<std::size_t>(line.data() - bytes().data());
    line_end_ = at_ + line.size() - (goes_on_ ? 1 : 0);
  }

  std::filesystem::path path_;
  bool joins_lines_;
  text_lines lines_;
  std::size_t at_ = 0, line_end_ = 0;
  bool in_line_ = false, goes_on_ = false;
};

/// Returns the mesh of the polygons that `read(path, polygons)` adds.
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
