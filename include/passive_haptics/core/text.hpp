/// Texts about invalid values, for any locale. Without streams (170 KB of flash) or std::to_chars (130 KB).
#pragma once

#include <passive_haptics/core/error_message.hpp>

#include <concepts>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace passive_haptics::detail {

/// Six digits, like "%g" in the C locale, but 1e7 instead of 1e+07.
inline std::string number_text(long double value) {
  constexpr int digit_count = 6;
  constexpr long double whole = 100'000;  // six digits before the point
  if (value != value) return "nan";
  std::string text(value < 0 ? 1 : 0, '-');
  if (value < 0) value = -value;
  if (value > std::numeric_limits<long double>::max()) return text.append("inf");
  if (value == 0) return "0";
  int exponent = 0;
  for (; value >= 10; value /= 10) ++exponent;
  for (; value < 1; value *= 10) --exponent;
  auto rounded = static_cast<long>(value * whole + 0.5L);
  if (rounded >= 10 * static_cast<long>(whole)) {
    rounded /= 10;
    ++exponent;
  }
  std::string digits = std::to_string(rounded);
  digits.erase(digits.find_last_not_of('0') + 1);
  const bool scientific = exponent < -4 || exponent >= digit_count;
  const int shift = scientific ? 0 : exponent;
  if (shift < 0) digits.insert(0, static_cast<std::size_t>(-shift), '0');
  const std::size_t point = shift < 0 ? 1 : static_cast<std::size_t>(shift) + 1;
  if (digits.size() < point) digits.resize(point, '0');
  if (digits.size() > point) digits.insert(point, 1, '.');
  if (scientific) digits.append("e").append(std::to_string(exponent));
  return text.append(digits);
}

template <class T>
std::string value_text(const T& value) {
  if constexpr (std::same_as<T, bool>) return value ? "true" : "false";
  else if constexpr (std::integral<T>) return std::to_string(value);
  else if constexpr (std::is_arithmetic_v<T>) return number_text(static_cast<long double>(value));
  else return std::string(value);
}

template <class T>
error_message error_text(std::string_view name, T value, std::string_view expected) {
  return error_of("a parameter", [&] {
    return std::string(name).append(" = ").append(value_text(value)).append(": expected ").append(expected);
  });
}

// Calls require_no_error() with an error_text if the condition does not hold.
template <class T>
void refuse_unless(bool holds, std::string_view name, T value, std::string_view expected) {
  if (!holds) require_no_error(error_text(name, value, expected));
}

/// "before i after". (A literal + std::string makes g++ 12 warn of overlapping memory at -O3.)
template <class Index>
std::string indexed(std::string_view before, Index i, std::string_view after) {
  return std::string(before).append(value_text(i)).append(after);
}

/// A text from a file, for a message: control characters, which could affect the terminal, become '?'.
inline std::string printable(std::string_view found) {
  std::string text(found);
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  return text;
}

/// The word of an enumerator, counted from 0; the last word for all values beyond.
template <class E, std::size_t N>
constexpr std::string_view word_of(E value, const char* const (&words)[N]) {
  const auto i = static_cast<std::size_t>(value);
  return words[i < N ? i : N - 1];
}

template <class... Errors>
error_message first_error(Errors... errors) {
  error_message first;
  ((first.empty() ? void(first = std::move(errors)) : void()), ...);
  return first;
}

}  // namespace passive_haptics::detail
