/// @file
/// The registers of lanes, and the truths that a comparison of lanes gives.
#pragma once

#include <passive_haptics/core/arithmetic.hpp>
#include <passive_haptics/core/unrolled.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>

namespace passive_haptics {
namespace detail {

// A register of T, 16 bytes as every x86-64 and ARM64 has: 2 doubles, 4 floats, or one number of another
// size.
template <class T>
struct packet_of {
  using type = T;
};
template <>
struct packet_of<double> {
  using type [[gnu::vector_size(16)]] = double;
};
template <>
struct packet_of<float> {
  using type [[gnu::vector_size(16)]] = float;
};
template <class T>
inline constexpr int packet_width = sizeof(typename packet_of<T>::type) / sizeof(T);

// What comparing two packets of T gives. In integers of 32 bits: g++ 12 would choose doubles one by one.
template <class T>
struct truths_of {
  using type [[gnu::vector_size(16)]] = std::int32_t;
};
template <class T>
  requires std::same_as<typename packet_of<T>::type, T>
struct truths_of<T> {
  using type = bool;
};

// Bits of two packets: those of x where m is set, else those of y.
template <class Packet, class Bits>
[[gnu::always_inline]] inline Packet merged(const Bits& m, const Packet& x, const Packet& y) {
  return bit_cast<Packet>((bit_cast<Bits>(x) & m) | (bit_cast<Bits>(y) & ~m));
}
template <class Packet>
[[gnu::always_inline]] inline Packet with_sign_of(const Packet& x, const Packet& y) {
  return merged(bit_cast<truths_of<double>::type>(-Packet{}), x, y);
}

}  // namespace detail

/// N truths: what a comparison of lanes gives.
template <class T, int N>
struct lane_mask {
  static constexpr int width = detail::packet_width<T>;       ///< Numbers of a register.
  static constexpr int count = (N + width - 1) / width;       ///< Registers.
  typename detail::truths_of<T>::type p[std::size_t(count)];  ///< All bits of a number set where it is true.

  /// Truth i.
  [[gnu::always_inline]] bool operator[](int i) const {
    if constexpr (width == 1) return p[i];
    else return p[i / width][i % width * (4 / width)] < 0;  // its sign: shorter than all bits
  }

  /// Both.
  friend lane_mask operator&(lane_mask a, const lane_mask& b) {
    unrolled<count>([&](auto k) { a.p[k] = a.p[k] & b.p[k]; });
    return a;
  }
  /// One or both.
  friend lane_mask operator|(lane_mask a, const lane_mask& b) {
    unrolled<count>([&](auto k) { a.p[k] = a.p[k] | b.p[k]; });
    return a;
  }
};

}  // namespace passive_haptics
