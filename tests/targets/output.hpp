// Lines of text from a program that may have no operating system, no heap and no printf.
#pragma once

#include <passive_haptics/core/arithmetic.hpp>

#include <cstddef>
#include <cstdint>
#include <initializer_list>

namespace output {

// Where the target writes a text that ends with a zero.
void write(const char* text);

/// Words and numbers with spaces between them; written with its end. A float or double stands as C's %a has
/// it, each with all its digits: equal text is equal bits.
class line {
 public:
  explicit line(const char* name) {
    for (; *name != '\0'; ++name) put(*name);
  }
  line(const line&) = delete;
  ~line() {
    put('\n');
    text_[size_] = '\0';
    write(text_);
  }

  line& operator<<(int x) {
    put(' ');
    put_whole(x);
    return *this;
  }
  line& operator<<(double x) { return put_real(passive_haptics::detail::bit_cast<std::uint64_t>(x), 52, 11); }
  line& operator<<(float x) {  // one bit further left, so that its digits are whole
    const auto bits = passive_haptics::detail::bit_cast<std::uint32_t>(x);
    return put_real(static_cast<std::uint64_t>(bits) << 1, 24, 8);
  }

 private:
  line& put_real(std::uint64_t bits, int digit_bits, int exponent_bits) {
    const auto ones = [](int count) { return (std::uint64_t(1) << count) - 1; };
    const std::uint64_t digits = bits & ones(digit_bits);
    const auto exponent = static_cast<int>(bits >> digit_bits & ones(exponent_bits));
    const auto bias = static_cast<int>(ones(exponent_bits - 1));
    put(' ');
    if (bits >> (digit_bits + exponent_bits) & 1) put('-');
    if (exponent == static_cast<int>(ones(exponent_bits))) {
      for (const char c : {'n', 'a', 'n'}) put(c);
      return *this;
    }
    for (const char c : {'0', 'x', exponent == 0 ? '0' : '1', '.'}) put(c);
    for (int at = digit_bits - 4; at >= 0; at -= 4) put("0123456789abcdef"[digits >> at & 15]);
    put('p');
    put_whole(digits == 0 && exponent == 0 ? 0 : (exponent == 0 ? 1 : exponent) - bias);
    return *this;
  }
  void put_whole(int x) {
    if (x < 0) put('-');
    const unsigned size = x < 0 ? -static_cast<unsigned>(x) : static_cast<unsigned>(x);
    unsigned unit = 1;
    while (size / unit >= 10) unit *= 10;
    for (; unit > 0; unit /= 10) put(static_cast<char>('0' + size / unit % 10));
  }
  void put(char c) {
    if (size_ + 1 < sizeof text_) text_[size_++] = c;
  }

  char text_[1024];
  std::size_t size_ = 0;
};

}  // namespace output
