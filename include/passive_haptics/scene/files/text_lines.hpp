/// Lines and numbers of a text.
#pragma once

#include <passive_haptics/core/text.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <clocale>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <istream>
#include <limits>
#include <locale>  // strtod_l of macOS
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <utility>

namespace passive_haptics::detail {

/// True if a word is this keyword, in lower or upper case; `keyword` is in lower case.
inline bool is_keyword(std::string_view word, std::string_view keyword) {
  return std::equal(word.begin(), word.end(), keyword.begin(), keyword.end(),
                    [](char c, char letter) { return (c >= 'A' && c <= 'Z' ? c + 32 : c) == letter; });
}

/// Returns an error text if the first bytes of a file belong to a foreign kind of file; else empty.
inline std::string foreign_file_error(std::string_view bytes) {
  using namespace std::string_view_literals;
  constexpr auto unpack = "expected the file itself; unpack it"sv;
  constexpr auto convert = "expected ASCII or UTF-8; save the file in one of these"sv;
  constexpr std::string_view kinds[][3] = {
      {"\x1f\x8b"sv, "compressed by gzip"sv, unpack},
      {"PK\x03\x04"sv, "a ZIP archive"sv, unpack},
      {"\xff\xfe"sv, "text in UTF-16"sv, convert},
      {"\xfe\xff"sv, "text in UTF-16"sv, convert},
      {"version https://git-lfs.github.com/"sv, "a Git LFS pointer, not the file"sv,
       "expected what it points to; run `git lfs pull`"sv}};
  for (const auto& [mark, found, expected] : kinds)
    if (bytes.starts_with(mark)) return std::string(found).append(": ").append(expected);
  bytes.remove_prefix(std::min(bytes.find_first_not_of("\xef\xbb\xbf \t\r\n"), bytes.size()));
  if (!is_keyword(bytes.substr(0, 14), "<!doctype html") && !is_keyword(bytes.substr(0, 5), "<html"))
    return "";
  return "an HTML page, not the file: expected the file itself; download that";
}

/// True if std::from_chars reads this type. libc++ before 20 lacks floating-point types.
template <class T>
concept has_from_chars = requires(const char* p, T& value) { std::from_chars(p, p, value); };

#ifndef _WIN32
/// Replaces std::from_chars of a double in a standard library without it.
inline std::from_chars_result from_chars_by_strtod(const char* begin, const char* end, double& value) {
  static const locale_t c = newlocale(LC_ALL_MASK, "C", nullptr);
  std::string text(begin, end);
  // strtod also accepts a blank or a plus before the number, and hexadecimal digits
  const std::size_t first = text.starts_with('-') ? 1 : 0;
  if (text.find_first_of("0123456789.iInN", first) != first) return {begin, std::errc::invalid_argument};
  text.resize(std::min(text.find_first_of("xX"), text.size()));
  char* stop = nullptr;
  const double found = strtod_l(text.c_str(), &stop, c);
  if (stop == text.c_str()) return {begin, std::errc::invalid_argument};
  const char* const read_to = begin + (stop - text.c_str());
  if (std::isinf(found) && text.find_first_of("iI") != first)
    return {read_to, std::errc::result_out_of_range};
  value = found;
  return {read_to, std::errc()};
}
#endif

/// Parses the number at the start of a text, with the result of std::from_chars. Also accepts a leading plus,
/// and "-1.#IND", "1.#QNAN" and "1.#INF" of old Windows programs as NaN and infinity.
template <class T>
std::from_chars_result read_number(std::string_view text, T& value) {
  const char *begin = text.data(), *const end = begin + text.size();
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') ++begin;
  std::from_chars_result read;
  if constexpr (has_from_chars<T>) read = std::from_chars(begin, end, value);
  else read = from_chars_by_strtod(begin, end, value);
  if constexpr (std::is_floating_point_v<T>) {
    const std::string_view rest(read.ptr, static_cast<std::size_t>(end - read.ptr));
    if (read.ec != std::errc() || !rest.starts_with('#') || std::abs(value) != 1) return read;
    for (const std::string_view name : {"#INF", "#IND", "#QNAN", "#SNAN"}) {
      if (!rest.starts_with(name)) continue;
      using limits = std::numeric_limits<T>;
      value *= name == "#INF" ? limits::infinity() : limits::quiet_NaN();
      read.ptr += std::min(rest.find_first_not_of('0', name.size()), rest.size());
    }
  }
  return read;
}

/// The likely cause of a word that is not a number, as the end of a message; empty if unknown.
inline std::string_view cause_of_no_number(std::string_view word, bool ends_file) {
  if (word.empty() || word.find_first_not_of("0123456789.eE+-,") != word.npos) return "";
  if (word.find(',') != word.npos) return "; write a decimal point instead of the comma";
  return ends_file && std::string_view("eE+-").find(word.back()) != word.npos ? "; the file was cut off" : "";
}

/// Lines of a text, with or without byte order mark, ended by LF, CR LF or CR; the end may be padded.
class text_lines {
 public:
  static constexpr std::string_view padding{"\0\x1a \t\r\n\v\f", 8};  ///< Padding bytes at the end.

  explicit text_lines(std::string text) : bytes_(std::move(text)) {}  ///< Reads a text in memory.
  /// Reads a stream in pieces. A line has at most `max_length` bytes.
  text_lines(std::istream& in, std::size_t max_length) : in_(&in), max_length_(max_length) {}

  /// Allows at most this many zero bytes at the end, since more could hide lost lines.
  void limit_zeros(std::ptrdiff_t max_zeros) { max_zeros_ = max_zeros; }
  /// Goes to the next line. Returns false at the end of the text or if there is an error().
  bool next() {
    line_ = std::string_view(bytes_).substr(at_, 0);
    if (is_last_) return false;
    ++number_;
    if (in_ != nullptr && bytes_.size() - at_ <= max_length_ + 1) read_more();
    if (number_ == 1 && bytes_.starts_with("\xef\xbb\xbf")) at_ = 3;
    std::size_t end = std::min({find(lf), find(cr), bytes_.size()});
    if (const std::size_t from = std::min(find(zero), find(dos_end)); from < end) {
      const std::string_view rest = std::string_view(bytes_).substr(end = from);
      padding_size_ = rest.size();
      if (in_ != nullptr || rest.find_first_not_of(padding) != rest.npos ||
          std::count(rest.begin(), rest.end(), '\0') > max_zeros_)
        fail("a zero byte or Ctrl-Z: expected text; lines may be lost here: if none is, remove such bytes");
    }
    if (end - at_ > max_length_)
      fail(indexed("more than ", max_length_, " characters: expected a shorter line"));
    line_ = std::string_view(bytes_).substr(at_, end - at_);
    is_last_ = end + padding_size_ == bytes_.size() || !error_.empty();
    if (after_cr_ <= end) after_cr_ = std::min(bytes_.find_first_not_of('\r', end), bytes_.size());
    at_ = is_last_ ? end : (after_cr_ == find(lf) ? after_cr_ : end) + 1;
    return error_.empty() && (!is_last_ || !line_.empty());
  }
  std::string_view line() const { return line_; }  ///< The line without its end, valid until next().
  /// Line number, from 1; one past the last line at the end of the text.
  std::size_t number() const { return number_; }
  bool is_last() const { return is_last_; }  ///< True if nothing follows this line, not even its end.
  const std::string& error() const { return error_; }  ///< The error of this line; empty if there is none.
  /// Number of padding bytes, once the end of the text was reached.
  std::size_t padding_size() const { return padding_size_; }
  /// The part of the text in memory, and the position in it of the next line.
  const std::string& bytes() const { return bytes_; }
  std::size_t position() const { return at_; }

 private:
  enum mark { lf, cr, zero, dos_end };
  static constexpr std::size_t none = std::string::npos, unknown = none - 1;

  void fail(const std::string& error) {
    if (error_.empty()) error_ = error;
  }
  // The first of these characters not yet read; searched only once
  std::size_t find(mark m) {
    if (marks_[m] == unknown || marks_[m] < at_) marks_[m] = bytes_.find("\n\r\0\x1a"[m], at_);
    return marks_[m];
  }
  void read_more() {
    constexpr std::size_t piece = 1 << 16;  // > max_length_
    bytes_.erase(0, at_);
    const std::size_t before = bytes_.size();
    bytes_.resize(before + piece);
    const auto got = in_->rdbuf()->sgetn(bytes_.data() + before, static_cast<std::streamsize>(piece));
    bytes_.resize(before + static_cast<std::size_t>(got));
    if (bytes_.size() < before + piece) in_ = nullptr;
    at_ = after_cr_ = 0;
    marks_.fill(unknown);
    if (number_ == 1) fail(foreign_file_error(bytes_));
  }

  std::istream* in_ = nullptr;
  std::size_t max_length_ = none;
  std::ptrdiff_t max_zeros_ = std::numeric_limits<std::ptrdiff_t>::max();
  std::string bytes_, error_;
  std::string_view line_;
  std::size_t at_ = 0, number_ = 0, padding_size_ = 0;
  bool is_last_ = false;
  std::array<std::size_t, 4> marks_{unknown, unknown, unknown, unknown};  // position in bytes_ of each mark
  std::size_t after_cr_ = 0;  // position after consecutive CRs at the end of a line
};

}  // namespace passive_haptics::detail
