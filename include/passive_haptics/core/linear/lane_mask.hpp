/// Registers, masks from comparisons of lanes, and exchanges between two lanes.
#pragma once

#include <passive_haptics/core/arithmetic.hpp>
#include <passive_haptics/core/flatten.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace passive_haptics {
namespace detail {

// A 16-byte register, as on every x86-64 and ARM64: 2 doubles, 4 floats, or one other number.
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

// Result of comparing two packets, in 32-bit integers: with 64 bits g++ 12 selects doubles one by one.
template <class T>
struct truths_of {
  using type [[gnu::vector_size(16)]] = std::int32_t;
};
template <class T>
  requires std::same_as<typename packet_of<T>::type, T>
struct truths_of<T> {
  using type = bool;
};

// Bits of x if m is set, else of y.
template <class Packet, class Bits>
PASSIVE_HAPTICS_INLINE inline Packet merged(const Bits& m, const Packet& x, const Packet& y) {
  return bit_cast<Packet>((bit_cast<Bits>(x) & m) | (bit_cast<Bits>(y) & ~m));
}
template <class Packet>
PASSIVE_HAPTICS_INLINE inline Packet with_sign_of(const Packet& x, const Packet& y) {
  return merged(bit_cast<truths_of<double>::type>(-Packet{}), x, y);
}

}  // namespace detail

/// Mask of N lanes, the result of a comparison.
template <class T, int N>
struct lane_mask {
  static constexpr int width = detail::packet_width<T>;       ///< Numbers per register.
  static constexpr int count = (N + width - 1) / width;       ///< Number of registers.
  typename detail::truths_of<T>::type p[std::size_t(count)];  ///< All bits of a true lane are set.

  /// Lane i is bit i of `set`.
  PASSIVE_HAPTICS_INLINE static lane_mask of(unsigned set) {
    lane_mask x;
    unrolled<count>([&](auto k) PASSIVE_HAPTICS_INLINE {
      if constexpr (width == 1) {
        x.p[k] = (set >> k & 1u) != 0;
      } else {
        using truths = typename detail::truths_of<T>::type;
        const auto flag = [&](int part) PASSIVE_HAPTICS_INLINE {
          return static_cast<int>(1u << (k * width + part * width / 4));
        };
        const truths flags{flag(0), flag(1), flag(2), flag(3)};
        const int all = static_cast<int>(set);
        x.p[k] = (truths{all, all, all, all} & flags) == flags;
      }
    });
    return x;
  }

  /// True if lane i is set.
  PASSIVE_HAPTICS_INLINE bool operator[](int i) const {
    if constexpr (width == 1) return p[i];
    else return p[i / width][i % width * (4 / width)] < 0;  // the sign: shorter than all bits
  }

  /// Equality of all lanes, including the unused ones.
  PASSIVE_HAPTICS_INLINE friend bool operator==(const lane_mask& a, const lane_mask& b) {
    if constexpr (width == 1) {
      bool all = true;
      unrolled<count>([&](auto k) PASSIVE_HAPTICS_INLINE { all &= a.p[k] == b.p[k]; });
      return all;
    } else {
      using halves [[gnu::vector_size(16)]] = std::int64_t;
      auto different = a.p[0] ^ b.p[0];
      unrolled<count - 1>([&](auto k) PASSIVE_HAPTICS_INLINE { different |= a.p[k + 1] ^ b.p[k + 1]; });
      const auto h = detail::bit_cast<halves>(different);
      return (h[0] | h[1]) == 0;
    }
  }
  /// Logical and.
  PASSIVE_HAPTICS_INLINE friend lane_mask operator&(lane_mask a, const lane_mask& b) {
    unrolled<count>([&](auto k) PASSIVE_HAPTICS_INLINE { a.p[k] = a.p[k] & b.p[k]; });
    return a;
  }
  /// Logical or.
  PASSIVE_HAPTICS_INLINE friend lane_mask operator|(lane_mask a, const lane_mask& b) {
    unrolled<count>([&](auto k) PASSIVE_HAPTICS_INLINE { a.p[k] = a.p[k] | b.p[k]; });
    return a;
  }
};

/// Returns (x_1, x_0). x: two lanes or a mask of two.
template <class X>
PASSIVE_HAPTICS_INLINE inline X swapped(X x) {
  if constexpr (X::width == 1) std::swap(x.p[0], x.p[1]);
  else if constexpr (X::width * sizeof(x.p[0][0]) == 8)
    x.p[0] = __builtin_shufflevector(x.p[0], x.p[0], 2, 3, 0, 1);
  else if constexpr (X::width == 2) x.p[0] = __builtin_shufflevector(x.p[0], x.p[0], 1, 0);
  else x.p[0] = __builtin_shufflevector(x.p[0], x.p[0], 1, 0, 2, 3);
  return x;
}

/// Keeps the second lane only if the first is not set.
template <class T>
PASSIVE_HAPTICS_INLINE inline lane_mask<T, 2> first_only(lane_mask<T, 2> x) {
  using truths = typename detail::truths_of<T>::type;
  if constexpr (x.width == 1) x.p[1] = x.p[1] & !x.p[0];
  else if constexpr (x.width == 2) x.p[0] &= ~(swapped(x).p[0] & truths{0, 0, -1, -1});
  else x.p[0] &= ~(swapped(x).p[0] & truths{0, -1, 0, 0});
  return x;
}

}  // namespace passive_haptics
