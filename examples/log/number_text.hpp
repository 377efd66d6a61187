/// Numbers as the shortest text that reads back exactly, independent of the locale.
#pragma once

#include <array>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace example {

/// Sets `text` to the shortest text of this number.
template <class Number>
void set_to_number(std::string& text, Number value) {
  std::array<char, 32> digits;
  if constexpr (requires(char* p) { std::to_chars(p, p, value); }) {
    text.assign(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
  } else {                                           // libc++ before 14
    constexpr int min_digits = 15, max_digits = 17;  // 17 digits suffice for each double
    for (int count = min_digits; count <= max_digits; ++count) {
      std::snprintf(digits.data(), digits.size(), "%.*g", count, value);
      if (std::strtod(digits.data(), nullptr) == value) break;
    }
    text = digits.data();
  }
}

}  // namespace example
