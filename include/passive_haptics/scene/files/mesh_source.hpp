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

/// Whether a word is this keyword, in small letters or capitals; `keyword` is in small letters.
inline bool is_keyword(std::string_view word, std::string_view keyword) {
  return std::ranges::equal(
      word, keyword, [](char c, char letter) { return (c >= 'A' && c <= 'Z' ? c + 32 : c) == letter; });
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
      : path_(std::move(path)), joins_lines_(joins_lines) {
    if (const std::string error = read_file(path_, bytes_); !error.empty()) fail_mesh_file(path_, error);
  }

  // ---- text

  /// Takes the bytes before `end` as text: passes over the mark of UTF-8 at the begin of the file, and lets a
  /// CR without a LF end a line, as on old Macs.
  void begin_text(std::size_t end = std::string::npos) {
    if (is_utf16()) fail_here("text in UTF-16", "ASCII or UTF-8; save the file in one of these");
    if (at_ == 0 && bytes_.starts_with("\xef\xbb\xbf")) at_ = 3;
    end = std::min(end, bytes_.size());
    for (std::size_t cr = bytes_.find('\r', at_); cr < end; cr = bytes_.find('\r', cr)) {
      const std::size_t next = std::min(bytes_.find_first_not_of('\r', cr), bytes_.size());
      if (next < bytes_.size() && bytes_[next] == '\n') cr = next;
      while (cr < std::min(next, end)) bytes_[cr++] = '\n';
    }
  }
  /// Whether the file begins with a mark of UTF-16.
  bool is_utf16() const { return bytes_.starts_with("\xff\xfe") || bytes_.starts_with("\xfe\xff"); }
  /// Cuts zero bytes and Ctrl-Z, the end of a text under DOS, off the end of the text; how many bytes. More
  /// zero bytes than `most_zeros` are an error.
  std::size_t cut_padding(std::size_t most_zeros = std::string::npos) {
    const std::size_t text = bytes_.find_last_not_of(padding) + 1;  // npos + 1 is 0
    const std::size_t from = std::max(at_, bytes_.find_first_of(padding.substr(0, 2), text));
    if (from >= bytes_.size()) return 0;
    const std::string cut = bytes_.substr(from);
    bytes_.resize(from);
    const auto zeros = static_cast<std::size_t>(std::ranges::count(cut, '\0'));
    if (zeros <= most_zeros) return cut.size();
    while (at_ < bytes_.size()) next_line();
    fail_mesh_file(path_, indexed("line ", line_, indexed(": ", zeros, " zero bytes, expected at most "))
                              .append(indexed("", most_zeros,
                                              " at the end; lines may be lost there: if none "
                                              "is, remove these bytes")));
  }
  /// The next word of this line; empty at its end.
  std::string_view word_in_line() {
    while (at_ < bytes_.size() && (is_blank(bytes_[at_]) || line_goes_on())) {
      if (bytes_[at_] == '\\') next_line();
      else ++at_;
    }
    const std::size_t from = at_;
    while (at_ < bytes_.size() && !is_blank(bytes_[at_]) && bytes_[at_] != '\n' && !line_goes_on()) ++at_;
    return std::string_view(bytes_).substr(from, at_ - from);
  }
  /// The next word, in whatever line; empty at the end of the file.
  std::string_view word() {
    for (;;) {
      if (const std::string_view found = word_in_line(); !found.empty() || at_ == bytes_.size()) return found;
      next_line();
    }
  }
  /// Goes to the begin of the next line, or to the end of the file. True if a backslash joins it to the line
  /// before.
  bool next_line() {
    const std::size_t from = at_;
    at_ = std::min(bytes_.find('\n', at_), bytes_.size());
    if (at_ == bytes_.size()) return false;
    std::size_t last = at_;
    while (last > from && bytes_[last - 1] == '\r') --last;
    ++at_;
    ++line_;
    return joins_lines_ && last > from && bytes_[last - 1] == '\\';
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
  /// The word that was read last with its line, for a message: "line 7: 'Kd'".
  std::string place_of(std::string_view found) const {
    return indexed("line ", line_, ": ")
        .append(!found.empty()         ? quoted(found)
                : at_ == bytes_.size() ? "the file ends"
                                       : "the line ends");
  }
  /// Ends with an error about the word that was read last.
  [[noreturn]] void fail(std::string_view found, std::string_view expected) const {
    fail_mesh_file(path_, place_of(found).append(", expected ").append(expected));
  }
  /// The line of the word that was read last, counted from 1.
  std::size_t line() const { return line_; }

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
  /// The byte that comes next, counted from 0.
  std::size_t byte() const { return at_; }
  /// Bytes that were not read yet.
  std::size_t left() const { return bytes_.size() - at_; }
  /// Whether they fill up the file and mean nothing: zero bytes, Ctrl-Z, blanks and ends of lines.
  bool only_padding_is_left() const { return bytes_.find_first_not_of(padding, at_) == std::string::npos; }
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
  bool line_goes_on() const {
    if (!joins_lines_ || bytes_[at_] != '\\') return false;
    const std::size_t end = bytes_.find_first_not_of('\r', at_ + 1);
    return end != bytes_.npos && bytes_[end] == '\n';
  }
  static constexpr std::string_view padding{"\0\x1a \t\r\n\v\f", 8};

  std::filesystem::path path_;
  bool joins_lines_;
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
