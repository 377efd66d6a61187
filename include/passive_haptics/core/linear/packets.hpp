/// @file
/// Short vectors in packets of 16 bytes, the registers of every x86-64 and ARM64.
#pragma once

#include <passive_haptics/core/scalar/bit_cast.hpp>
#include <passive_haptics/core/unrolled.hpp>

#include <cstring>
#include <type_traits>
#include <utility>

namespace passive_haptics::detail {

// A register of T: 2 doubles, 4 floats, or one number of another size.
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

/// N numbers, with zeros where the last packet has room for more: so there is no scalar rest, which Eigen has
/// for odd N. Fast where the caller is PASSIVE_HAPTICS_FLATTEN: the numbers then live in registers, at -O2 as
/// well.
template <class T, int N>
struct packets {
  using packet = typename packet_of<T>::type;  ///< A register of T.
  static constexpr int width = sizeof(packet) / sizeof(T), count = (N + width - 1) / width, rest = N % width;

  packet p[std::size_t(count)];

  /// x[0] .. x[N - 1], at any address.
  [[gnu::always_inline]] static packets load(const T* x) {
    packets a;
    unrolled<N / width>([&](auto i) { std::memcpy(&a.p[i], x + i * width, sizeof(packet)); });
    if constexpr (rest != 0) {
      [&]<int... I>(std::integer_sequence<int, I...>) {
        a.p[count - 1] = packet{x[N - rest + I]...};
      }(std::make_integer_sequence<int, rest>());
    }
    return a;
  }

  /// Stores x[0] .. x[N - 1].
  [[gnu::always_inline]] void store(T* x) const {
    unrolled<N / width>([&](auto i) { std::memcpy(x + i * width, &p[i], sizeof(packet)); });
    if constexpr (rest != 0) unrolled<rest>([&](auto i) { x[N - rest + i] = p[count - 1][i]; });
  }

  /// Of each packet y = f(x).
  template <class F>
  [[gnu::always_inline]] packets map(F&& f) const {
    packets a;
    unrolled<count>([&](auto i) { a.p[i] = f(p[i]); });
    return a;
  }

  /// += s x
  [[gnu::always_inline]] void add(T s, const packets& x) {
    unrolled<count>([&](auto i) { p[i] += s * x.p[i]; });
  }

  /// -= s x
  [[gnu::always_inline]] void subtract(T s, const packets& x) {
    unrolled<count>([&](auto i) { p[i] -= s * x.p[i]; });
  }

  /// The packet whose sum is the scalar product with x.
  [[gnu::always_inline]] packet products(const packets& x) const {
    if constexpr (count == 1) {
      return p[0] * x.p[0];
    } else {  // two sums, neither of which waits for the other
      packet even = p[0] * x.p[0], odd = p[1] * x.p[1];
      unrolled<count - 2>([&](auto i) { (i % 2 == 0 ? even : odd) += p[i + 2] * x.p[i + 2]; });
      return even + odd;
    }
  }

  /// Scalar product with x.
  [[gnu::always_inline]] T dot(const packets& x) const {
    const packet s = products(x);
    if constexpr (width == 1) return s;
    else if constexpr (width == 2) return s[0] + s[1];
    else return (s[0] + s[2]) + (s[1] + s[3]);
  }
};

/// N numbers, number j the sum over the packet f(j): added crosswise, in half of the instructions of N sums.
template <class T, int N, class F>
[[gnu::always_inline]] inline packets<T, N> sums(F&& f) {
  using packet = typename packets<T, N>::packet;
  constexpr int width = packets<T, N>::width;
  packets<T, N> a;
  unrolled<packets<T, N>::count>([&](auto i) {
    packet x[std::size_t(width)];
    unrolled<width>([&](auto k) { x[k] = i * width + k < N ? f(i * width + k) : packet{}; });
    if constexpr (width == 1) {
      a.p[i] = x[0];
    } else if constexpr (width == 2) {
      a.p[i] = __builtin_shufflevector(x[0], x[1], 0, 2) + __builtin_shufflevector(x[0], x[1], 1, 3);
    } else {
      const packet y =
          __builtin_shufflevector(x[0], x[1], 0, 4, 1, 5) + __builtin_shufflevector(x[0], x[1], 2, 6, 3, 7);
      const packet z =
          __builtin_shufflevector(x[2], x[3], 0, 4, 1, 5) + __builtin_shufflevector(x[2], x[3], 2, 6, 3, 7);
      a.p[i] = __builtin_shufflevector(y, z, 0, 1, 4, 5) + __builtin_shufflevector(y, z, 2, 3, 6, 7);
    }
  });
  return a;
}

// Integers of the size of T, and a register of them.
template <class T>
using integer_of = std::conditional_t<sizeof(T) == 8, long long, int>;
template <class T>
struct integers_of {
  using type [[gnu::vector_size(16)]] = integer_of<T>;
};

// first, first + 1, ...: where a packet's numbers stand.
template <class T>
[[gnu::always_inline]] inline auto places(int first) {
  return [&]<int... K>(std::integer_sequence<int, K...>) {
    return typename integers_of<T>::type{integer_of<T>(first + K)...};
  }(std::make_integer_sequence<int, packets<T, 1>::width>());
}

/// The set of j with x[j] > 0, a bit for each.
template <class T, int N>
[[gnu::always_inline]] inline unsigned positive_entries(const packets<T, N>& x) {
  constexpr int width = packets<T, N>::width;
  unsigned set = 0;
  if constexpr (width == 1) {
    for (int i = 0; i < N; ++i) set |= (x.p[i] > T(0) ? 1u : 0u) << i;
  } else {
    using packet = typename packets<T, N>::packet;
    using integers = typename integers_of<T>::type;
    const integers one = integers{} + 1;
    integers bits{};
    unrolled<packets<T, N>::count>(
        [&](auto i) { bits |= (x.p[i] > packet{}) & (one << places<T>(i * width)); });
    unrolled<width>([&](auto k) { set |= static_cast<unsigned>(bits[k]); });
  }
  return set;
}

/// The largest of x >= 0; what is NaN counts as 0.
template <class T, int N>
[[gnu::always_inline]] inline T largest_value(const packets<T, N>& x) {
  typename packets<T, N>::packet most{};
  unrolled<packets<T, N>::count>([&](auto i) { most = x.p[i] > most ? x.p[i] : most; });
  if constexpr (packets<T, N>::width == 1) {
    return most;
  } else {
    T value = most[0];
    unrolled<packets<T, N>::width - 1>([&](auto k) { value = most[k + 1] > value ? most[k + 1] : value; });
    return value;
  }
}

/// The largest of a vector's numbers and where it stands.
template <class T>
struct largest_entry {
  T value;
  int index;
};

// The index takes the place of the last five bits while they are compared.
template <class T, int N>
[[gnu::always_inline]] inline largest_entry<T> largest_of_marked(const packets<T, N>& x) {
  using packet = typename packets<T, N>::packet;
  using integers = typename integers_of<T>::type;
  constexpr int width = packets<T, N>::width;
  constexpr integer_of<T> last_bits = 31;
  static_assert(N <= last_bits + 1);
  packets<T, N> marked;
  unrolled<packets<T, N>::count>([&](auto i) {
    marked.p[i] = bit_cast<packet>((bit_cast<integers>(x.p[i]) & ~last_bits) | places<T>(i * width));
  });
  const auto bits = bit_cast<integer_of<T>>(largest_value(marked));
  return {bit_cast<T>(bits & ~last_bits), static_cast<int>(bits & last_bits)};
}

/// The largest of x >= 0, to 64 roundings. Which one it is, no processor could predict, so there is no
/// branch.
template <class T, int N>
[[gnu::always_inline]] inline largest_entry<T> largest(const packets<T, N>& x) {
  if constexpr (packets<T, N>::width == 1) {
    largest_entry<T> most{T(0), 0};
    for (int i = 0; i < N; ++i) {
      if (x.p[i] > most.value) most = {x.p[i], i};
    }
    return most;
  } else {
    return largest_of_marked(x);
  }
}

}  // namespace passive_haptics::detail
