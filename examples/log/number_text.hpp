/// @file
/// Numbers as the shortest text that reads back as the same number, in no locale.
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>

namespace example {

#ifdef __cpp_lib_to_chars
inline constexpr bool has_to_chars = true;  ///< Whether the standard library writes and reads a double.
#else
inline constexpr bool has_to_chars = false;  ///< Whether the standard library writes and reads a double.
#endif

/// Sets `text` to the shortest text that reads back as this number.
template <class Number>
void set_to_number(std::string& text, Number value) {
  std::array<char, 32> digits;
  if constexpr (has_to_chars || std::is_integral_v<Number>) {
    const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    text.assign(digits.data(), end);
  } else {
    constexpr int fewest = 15, most = 17;  // 17 digits suffice for each double
    for (int count = fewest; count <= most; ++count) {
      std::snprintf(digits.data(), digits.size(), "%.*g", count, value);
      if (std::strtod(digits.data(), nullptr) == value) break;
    }
    text = digits.data();
  }
}

/// std::from_chars of a double: what it read, where it stopped, and result_out_of_range.
template <class Number = double>
std::from_chars_result read_number(const char* begin, const char* end, Number& value) {
  if constexpr (has_to_chars) {
    return std::from_chars(begin, end, value);
  } else {
    // strtod also reads what from_chars does not: a space or plus before the number, and hexadecimal digits
    const std::string text(begin, end);
    const std::size_t first = text.starts_with('-') ? 1 : 0;
    constexpr std::string_view beginnings = "0123456789.iInN";
    const bool begins = text.size() > first && beginnings.find(text[first]) != beginnings.npos;
    if (!begins) return {begin, std::errc::invalid_argument};
    if (text.size() > first + 1 && text[first] == '0' && (text[first + 1] | 0x20) == 'x') {
      value = first == 0 ? 0.0 : -0.0;
      return {begin + first + 1, std::errc()};
    }
    char* stop = nullptr;
    const double found = std::strtod(text.c_str(), &stop);
    if (stop == text.c_str()) return {begin, std::errc::invalid_argument};
    const char* const read_to = begin + (stop - text.c_str());
    const bool is_word = text.find_first_of("iInN") < std::size_t(stop - text.c_str());
    if (std::isinf(found) && !is_word) return {read_to, std::errc::result_out_of_range};
    value = found;
    return {read_to, std::errc()};
  }
}

}  // namespace example
