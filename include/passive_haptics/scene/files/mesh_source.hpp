/// @file
/// The bytes of a mesh file, read from front to back, and errors that say where in it.
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

/// Throws std::invalid_argument that names the file.
[[noreturn]] inline void fail_mesh_file(const std::filesystem::path& path, const std::string& error) {
  require_no_error(std::string("mesh file ").append(path.string()).append(": ").append(printable(error)));
  std::abort();
}

/// A word as messages show it; of a long one the begin.
inline std::string quoted(std::string_view word) {
  constexpr std::size_t max_length = 40;  // characters
  return std::string("'").append(word.substr(0, max_length)).append(word.size() > max_length ? "...'" : "'");
}

/// Words and values of a file, in order. What is not there or is no such value ends with an error that names
/// the file, the line of a text or the byte of binary data, what stands there and what was expected.
class mesh_source {
 public:
  /// Reads the whole file. With `joins_lines` a backslash at the end of a line joins the next one to it.
  explicit mesh_source(std::filesystem::path path, bool joins_lines = false)
      : path_(std::move(path)), joins_lines_(joins_lines), lines_(read_or_fail(path_)) {}

  // ---- text

  /// The lines that words are taken from.
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
  /// The next word, in whatever line; empty at the end of the file.
  std::string_view word() {
    for (;;) {
      if (const std::string_view found = word_in_line(); !found.empty() || lines_.is_last()) return found;
      next_line();
    }
  }
  /// Goes to the begin of the next line, or to the end of the file. True if a backslash joins it to the line
  /// before.
  bool next_line() {
    if (!in_line_) begin_line();
    at_ = lines_.position();
    in_line_ = lines_.is_last();
    return std::exchange(goes_on_, false);
  }
  /// A word that stands for a number: the whole of it.
  template <class T>
  T number(std::string_view text, const char* expected) const {
    T value{};
    const auto [stop, error] = read_number(text, value);
    if (error != std::errc() || stop != text.data() + text.size())
      fail(text, std::string(expected).append(cause_of_no_number(text, lines_.is_last())));
    return value;
  }
  /// The word that was read last with its line, for a message: "line 7: 'Kd'".
  std::string place_of(std::string_view found) const {
    return indexed("line ", lines_.number(), ": ")
        .append(!found.empty()     ? quoted(found)
                : lines_.is_last() ? "the file ends"
                                   : "the line ends");
  }
  /// Ends with an error about the word that was read last.
  [[noreturn]] void fail(std::string_view found, std::string_view expected) const {
    fail_mesh_file(path_, place_of(found).append(", expected ").append(expected));
  }
  /// The line of the word that was read last, counted from 1.
  std::size_t line() const { return lines_.number(); }

  // ---- binary data

  /// The next value, whose bytes stand in this order.
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
  /// Goes on to this byte.
  void seek(std::size_t byte) { at_ = byte; }
  /// The byte that comes next, counted from 0.
  std::size_t byte() const { return at_; }
  /// Bytes that were not read yet.
  std::size_t left() const { return bytes().size() - at_; }
  /// Whether they fill up the file and mean nothing: zero bytes, Ctrl-Z, blanks and ends of lines.
  bool only_padding_is_left() const {
    return bytes().find_first_not_of(text_lines::padding, at_) == std::string::npos;
  }
  /// Ends with an error about the byte that comes next.
  [[noreturn]] void fail_here(std::string_view found, std::string_view expected) const {
    fail_mesh_file(path_, indexed("byte ", at_, ": ").append(found).append(", expected ").append(expected));
  }

  /// All of it.
  std::string_view bytes() const { return lines_.bytes(); }
  /// Its name.
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
