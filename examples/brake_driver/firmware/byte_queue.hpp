/// Byte queue between an interrupt and the loop.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace firmware {

/// Lock-free: one writer, one reader.
template <std::uint32_t Size>
class byte_queue {
 public:
  std::uint32_t room() const {
    return Size - (in_.load(std::memory_order_relaxed) - out_.load(std::memory_order_acquire));
  }
  void push(std::uint8_t b) {
    const std::uint32_t in = in_.load(std::memory_order_relaxed);
    bytes_[in % Size] = b;
    in_.store(in + 1, std::memory_order_release);
  }
  bool pop(std::uint8_t& b) {
    const std::uint32_t out = out_.load(std::memory_order_relaxed);
    if (in_.load(std::memory_order_acquire) == out) return false;
    b = bytes_[out % Size];
    out_.store(out + 1, std::memory_order_release);
    return true;
  }
  bool empty() const { return room() == Size; }

 private:
  static_assert((Size & (Size - 1)) == 0, "so that the counters may wrap");
  std::array<std::uint8_t, Size> bytes_{};
  std::atomic<std::uint32_t> in_{0}, out_{0};
};

}  // namespace firmware
