/// @file
/// N numbers at once, and choices between them that no branch makes.
#pragma once

#include <passive_haptics/core/arithmetic.hpp>
#include <passive_haptics/core/linear/packets.hpp>
#include <passive_haptics/core/matrix.hpp>
#include <passive_haptics/core/scalar/bit_cast.hpp>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

namespace passive_haptics {
namespace detail {

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
  static constexpr int width = detail::packets<T, N>::width;  ///< Numbers of a register.
  static constexpr int count = detail::packets<T, N>::count;  ///< Registers.
  typename detail::truths_of<T>::type p[std::size_t(count)];  ///< All bits of a number set where it is true.

  /// Truth i.
  [[gnu::always_inline]] bool operator[](int i) const {
    if constexpr (width == 1) return p[i];
    else return p[i / width][i % width * (4 / width)] != 0;
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

/// N numbers, such as one for each brake. What is written of them holds of each. Which brake slips, or is
/// released, no processor can predict: a choice between lanes takes the same time whichever it is.
///
/// For a function that calculates; vectors hold what stays. Fast where the caller is PASSIVE_HAPTICS_FLATTEN:
/// the numbers then live in registers. Other types than float and double are computed one by one.
template <class T, int N>
struct lanes {
  using packet = typename detail::packets<T, N>::packet;  ///< A register of T.
  using mask = lane_mask<T, N>;                           ///< What a comparison gives.
  static constexpr int width = mask::width;               ///< Numbers of a register.
  static constexpr int count = mask::count;               ///< Registers.
  packet p[std::size_t(count)];                           ///< The numbers, and zeros beyond.

  lanes() = default;
  /// N times the same number, also beyond the last.
  lanes(T x) {
    unrolled<count>([&](auto k) {
      if constexpr (width == 1) p[k] = x;
      else if constexpr (width == 2) p[k] = packet{x, x};
      else p[k] = packet{x, x, x, x};
    });
  }
  /// f(0), ..., f(N - 1), and zeros beyond.
  template <class F>
    requires std::is_invocable_r_v<T, F, int>
  [[gnu::always_inline]] explicit lanes(const F& f) {
    unrolled<count>([&](auto k) {
      const auto number = [&](int i) { return k * width + i < N ? f(k * width + i) : T(0); };
      if constexpr (width == 1) p[k] = f(k);
      else if constexpr (width == 2) p[k] = packet{number(0), number(1)};
      else p[k] = packet{number(0), number(1), number(2), number(3)};
    });
  }
  /// The numbers of a vector. One by one: a load of a packet would wait for numbers that were stored alone.
  lanes(const vector<T, N>& x) : lanes([&](int i) { return x[i]; }) {}

  /// As a vector.
  [[gnu::always_inline]] operator vector<T, N>() const {
    constexpr int rest = N % width;
    vector<T, N> x;
    unrolled<N / width>([&](auto k) { std::memcpy(x.data() + k * width, &p[k], sizeof(packet)); });
    if constexpr (rest != 0) unrolled<rest>([&](auto i) { x[N - rest + i] = p[count - 1][i]; });
    return x;
  }
  /// Number i.
  [[gnu::always_inline]] T operator[](int i) const {
    if constexpr (width == 1) return p[i];
    else return p[i / width][i % width];
  }

  /// @cond
  // What f makes of each packet
  template <class F>
  [[gnu::always_inline]] static lanes each(F&& f) {
    lanes x;
    unrolled<count>([&](auto k) { x.p[k] = f(k); });
    return x;
  }
  template <class F>
  [[gnu::always_inline]] static mask test(F&& f) {
    mask x;
    unrolled<count>([&](auto k) { x.p[k] = detail::bit_cast<typename detail::truths_of<T>::type>(f(k)); });
    return x;
  }

  friend lanes operator-(const lanes& a) {
    return each([&](auto k) { return -a.p[k]; });
  }
  friend lanes operator+(const lanes& a, const lanes& b) {
    return each([&](auto k) { return a.p[k] + b.p[k]; });
  }
  friend lanes operator-(const lanes& a, const lanes& b) {
    return each([&](auto k) { return a.p[k] - b.p[k]; });
  }
  friend lanes operator*(const lanes& a, const lanes& b) {
    return each([&](auto k) { return a.p[k] * b.p[k]; });
  }
  friend lanes operator/(const lanes& a, const lanes& b) {
    return each([&](auto k) { return a.p[k] / b.p[k]; });
  }
  friend mask operator<(const lanes& a, const lanes& b) {
    return test([&](auto k) { return a.p[k] < b.p[k]; });
  }
  friend mask operator<=(const lanes& a, const lanes& b) {
    return test([&](auto k) { return a.p[k] <= b.p[k]; });
  }
  friend mask operator>(const lanes& a, const lanes& b) { return b < a; }
  friend mask operator>=(const lanes& a, const lanes& b) { return b <= a; }
  /// @endcond
};
/// Of a vector.
template <class T, int N>
lanes(const vector<T, N>&) -> lanes<T, N>;

/// a where it is true, else b.
template <class T, int N>
lanes<T, N> choose(const lane_mask<T, N>& where, const std::type_identity_t<lanes<T, N>>& a,
                   const std::type_identity_t<lanes<T, N>>& b) {
  return lanes<T, N>::each([&](auto k) {
    const auto& m = where.p[k];
    if constexpr (lanes<T, N>::width == 1) return m ? a.p[k] : b.p[k];
    else return detail::merged(m, a.p[k], b.p[k]);
  });
}

/// y with the sign of x.
template <class T, int N>
lanes<T, N> copysign(const std::type_identity_t<lanes<T, N>>& y, const lanes<T, N>& x) {
  return lanes<T, N>::each([&](auto k) {
    if constexpr (lanes<T, N>::width == 1) return std::copysign(y.p[k], x.p[k]);
    else return detail::with_sign_of(x.p[k], y.p[k]);
  });
}

/// |x|
template <class T, int N>
lanes<T, N> abs(const lanes<T, N>& x) {
  return copysign(x, lanes<T, N>(T(0)));
}

/// The root. Of doubles without a branch: std::sqrt has one, to set errno where x < 0. (Eigen's of four
/// floats is an approximation.)
template <class T, int N>
lanes<T, N> sqrt(const lanes<T, N>& x) {
  if constexpr (std::same_as<T, double>) return vector<T, N>(vector<T, N>(x).cwiseSqrt());
  else return lanes<T, N>([&](int i) { return std::sqrt(x[i]); });
}

/// -1, 0 or 1; 0 for NaN.
template <class T, int N>
lanes<T, N> sgn(const lanes<T, N>& x) {
  return choose(abs(x) > T(0), copysign(T(1), x), T(0));
}

/// The smaller of each two; a where one is NaN.
template <class T, int N>
lanes<T, N> min(const lanes<T, N>& a, const std::type_identity_t<lanes<T, N>>& b) {
  return lanes<T, N>::each([&](auto k) { return b.p[k] < a.p[k] ? b.p[k] : a.p[k]; });
}

/// The larger of each two; a where one is NaN.
template <class T, int N>
lanes<T, N> max(const lanes<T, N>& a, const std::type_identity_t<lanes<T, N>>& b) {
  return lanes<T, N>::each([&](auto k) { return a.p[k] < b.p[k] ? b.p[k] : a.p[k]; });
}

/// (x_1, x_0): of each of two what the other one has. x: lanes or a mask.
template <class X>
[[gnu::always_inline]] inline X swapped(X x) {
  if constexpr (X::width == 1) std::swap(x.p[0], x.p[1]);
  else if constexpr (X::width * sizeof(x.p[0][0]) == 8)
    x.p[0] = __builtin_shufflevector(x.p[0], x.p[0], 2, 3, 0, 1);
  else if constexpr (X::width == 2) x.p[0] = __builtin_shufflevector(x.p[0], x.p[0], 1, 0);
  else x.p[0] = __builtin_shufflevector(x.p[0], x.p[0], 1, 0, 2, 3);
  return x;
}

/// The first truth of two alone.
template <class T>
[[gnu::always_inline]] inline lane_mask<T, 2> first(lane_mask<T, 2> x) {
  using truths = typename detail::truths_of<T>::type;
  if constexpr (x.width == 1) x.p[1] = x.p[1] & !x.p[0];
  else if constexpr (x.width == 2) x.p[0] &= ~(swapped(x).p[0] & truths{0, 0, -1, -1});
  else x.p[0] &= ~(swapped(x).p[0] & truths{0, -1, 0, 0});
  return x;
}

}  // namespace passive_haptics
