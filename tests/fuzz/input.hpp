// What the fuzzers share: values out of the bytes that libFuzzer chose, and what is said of a finding.
#pragma once

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <span>
#include <string>
#include <string_view>

namespace fuzz {

// Takes values from the input; 0 once it has ended.
class reader {
 public:
  reader(const std::uint8_t* data, std::size_t size) : data_(data), end_(data + size) {}

  bool ended() const { return data_ == end_; }
  std::uint8_t byte() { return ended() ? std::uint8_t{0} : *data_++; }
  std::uint32_t word(int bytes) {
    std::uint32_t value = 0;
    for (int i = 0; i < bytes; ++i) value = value << 8 | byte();
    return value;
  }
  double number() {
    double x = 0;
    if (end_ - data_ < static_cast<std::ptrdiff_t>(sizeof x)) return 0;
    std::memcpy(&x, data_, sizeof x);
    data_ += sizeof x;
    return x;
  }
  template <class Vector>
  void fill(Vector& v) {
    for (int i = 0; i < v.size(); ++i) v[i] = static_cast<typename Vector::Scalar>(number());
  }
  // As many as there are, at most.
  std::span<const std::uint8_t> bytes(std::size_t most) {
    const std::span<const std::uint8_t> all(data_, end_);
    const auto some = all.first(most < all.size() ? most : all.size());
    data_ += some.size();
    return some;
  }
  std::string text() {
    const std::string all(data_, end_);
    data_ = end_;
    return all;
  }

 private:
  const std::uint8_t* data_;
  const std::uint8_t* end_;
};

// A finding unless this holds.
inline void require(bool holds, std::string_view what, std::string_view found = {}) {
  if (holds) return;
  std::printf("%.*s: %.*s\n", static_cast<int>(what.size()), what.data(), static_cast<int>(found.size()),
              found.data());
  std::fflush(stdout);
  std::abort();
}

// A message for somebody at a terminal.
inline void require_readable(const std::string& error) {
  require(std::none_of(error.begin(), error.end(),
                       [](char c) { return std::iscntrl(static_cast<unsigned char>(c)); }),
          "an error with control characters", error);
  require(error.size() < 10000, "a very long error", error);
}

inline bool has(std::string_view text, std::string_view part) { return text.find(part) != text.npos; }

}  // namespace fuzz
