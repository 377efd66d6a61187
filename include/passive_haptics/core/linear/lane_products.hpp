/// Reductions of lanes, and products of small matrices and vectors.
#pragma once

#include <passive_haptics/core/linear/lanes.hpp>

namespace passive_haptics {

/// Sum of all lanes.
template <class T, int N>
T sum(const lanes<T, N>& x) {
  T all = x[0];
  unrolled<N - 1>([&](auto i) PASSIVE_HAPTICS_INLINE { all += x[i + 1]; });
  return all;
}

/// x_0 y_0 + ... + x_{N-1} y_{N-1}, as a packet with this sum.
template <class T, int N>
PASSIVE_HAPTICS_INLINE inline auto products(const lanes<T, N>& x, const lanes<T, N>& y) {
  if constexpr (lanes<T, N>::count == 1) {
    return x.p[0] * y.p[0];
  } else {  // two independent sums
    typename lanes<T, N>::packet even = x.p[0] * y.p[0], odd = x.p[1] * y.p[1];
    unrolled<lanes<T, N>::count - 2>(
        [&](auto i) PASSIVE_HAPTICS_INLINE { (i % 2 == 0 ? even : odd) += x.p[i + 2] * y.p[i + 2]; });
    return even + odd;
  }
}

/// Dot product.
template <class T, int N>
PASSIVE_HAPTICS_INLINE inline T dot(const lanes<T, N>& x, const lanes<T, N>& y) {
  const auto s = products(x, y);
  if constexpr (lanes<T, N>::width == 1) return s;
  else if constexpr (lanes<T, N>::width == 2) return s[0] + s[1];
  else return (s[0] + s[2]) + (s[1] + s[3]);
}

/// Lane j is the sum over the packet f(j). Adds crosswise, with half the instructions of N sums.
template <class T, int N, class F>
PASSIVE_HAPTICS_INLINE inline lanes<T, N> horizontal_add(F&& f) {
  using packet = typename lanes<T, N>::packet;
  constexpr int width = lanes<T, N>::width;
  lanes<T, N> a;
  unrolled<lanes<T, N>::count>([&](auto i) PASSIVE_HAPTICS_INLINE {
    packet x[std::size_t(width)];
    unrolled<width>([&](auto k)
                        PASSIVE_HAPTICS_INLINE { x[k] = i * width + k < N ? f(i * width + k) : packet{}; });
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

/// Minimum of all lanes.
template <class T, int N>
T min_value(const lanes<T, N>& x) {
  T low = x[0];
  unrolled<N - 1>([&](auto i) PASSIVE_HAPTICS_INLINE { low = x[i + 1] < low ? x[i + 1] : low; });
  return low;
}

/// True if any lane is set.
template <class T, int N>
bool any(const lane_mask<T, N>& x) {
  bool some = false;
  unrolled<N>([&](auto i) PASSIVE_HAPTICS_INLINE { some |= x[i]; });
  return some;
}

/// Sets all lanes if any lane is set.
template <class T, int N>
PASSIVE_HAPTICS_INLINE inline lane_mask<T, N> any_of(const lane_mask<T, N>& x) {
  lane_mask<T, N> all;
  if constexpr (N == 2) {
    all = x | swapped(x);
  } else {
    const bool some = any(x);
    if constexpr (lane_mask<T, N>::width == 1)
      unrolled<N>([&](auto i) PASSIVE_HAPTICS_INLINE { all.p[i] = some; });
    else all = lane_mask<T, N>::of(some ? ~0u : 0u);
  }
  return all;
}

/// Bit i is lane i.
template <class T, int N>
PASSIVE_HAPTICS_INLINE inline unsigned bits(const lane_mask<T, N>& x) {
  using mask = lane_mask<T, N>;
  if constexpr (mask::width == 1) {
    unsigned all = 0;
    unrolled<N>([&](auto i) PASSIVE_HAPTICS_INLINE { all |= static_cast<unsigned>(x[i]) << i; });
    return all;
  } else {  // combines the registers first, then their lanes
    typename detail::truths_of<T>::type all{};
    unrolled<mask::count>([&](auto k) PASSIVE_HAPTICS_INLINE {
      const auto flag = [&](int part) PASSIVE_HAPTICS_INLINE {
        const int i = k * mask::width + part * mask::width / 4;
        return i < N ? 1 << i : 0;  // ignores lanes beyond N
      };
      all |= x.p[k] & typename detail::truths_of<T>::type{flag(0), flag(1), flag(2), flag(3)};
    });
    all |= __builtin_shufflevector(all, all, 2, 3, 0, 1);
    if constexpr (mask::width == 4) all |= __builtin_shufflevector(all, all, 1, 0, 3, 2);
    return static_cast<unsigned>(all[0]);
  }
}

namespace detail {

template <class T>
using integer_of = std::conditional_t<sizeof(T) == 8, long long, int>;
template <class T>
struct integers_of {
  using type [[gnu::vector_size(16)]] = integer_of<T>;
};

// Indices first, first + 1, ... of the numbers of a packet.
template <class T>
PASSIVE_HAPTICS_INLINE inline auto places(int first) {
  return [&]<int... K>(std::integer_sequence<int, K...>) {
    return typename integers_of<T>::type{integer_of<T>(first + K)...};
  }(std::make_integer_sequence<int, lanes<T, 1>::width>());
}

/// Maximum of all lanes, for x >= 0; NaN counts as 0.
template <class T, int N>
PASSIVE_HAPTICS_INLINE inline T max_value(const lanes<T, N>& x) {
  typename lanes<T, N>::packet largest{};
  unrolled<lanes<T, N>::count>([&](auto i)
                                   PASSIVE_HAPTICS_INLINE { largest = x.p[i] > largest ? x.p[i] : largest; });
  if constexpr (lanes<T, N>::width == 1) {
    return largest;
  } else {
    T value = largest[0];
    unrolled<lanes<T, N>::width - 1>(
        [&](auto k) PASSIVE_HAPTICS_INLINE { value = largest[k + 1] > value ? largest[k + 1] : value; });
    return value;
  }
}

template <class T>
struct max_entry {
  T value;
  int index;
};

// The index temporarily replaces the last five bits.
template <class T, int N>
PASSIVE_HAPTICS_INLINE inline max_entry<T> max_of_marked(const lanes<T, N>& x) {
  using packet = typename lanes<T, N>::packet;
  using integers = typename integers_of<T>::type;
  constexpr int width = lanes<T, N>::width;
  constexpr integer_of<T> last_bits = 31;
  static_assert(N <= last_bits + 1);
  lanes<T, N> marked;
  unrolled<lanes<T, N>::count>([&](auto i) PASSIVE_HAPTICS_INLINE {
    marked.p[i] = bit_cast<packet>((bit_cast<integers>(x.p[i]) & ~last_bits) | places<T>(i * width));
  });
  const auto bits = bit_cast<integer_of<T>>(max_value(marked));
  return {bit_cast<T>(bits & ~last_bits), static_cast<int>(bits & last_bits)};
}

/// Maximum of x >= 0 to 64 roundings, without a branch, which would be unpredictable.
template <class T, int N>
PASSIVE_HAPTICS_INLINE inline max_entry<T> find_max(const lanes<T, N>& x) {
  if constexpr (lanes<T, N>::width == 1) {
    max_entry<T> largest{T(0), 0};
    for (int i = 0; i < N; ++i) {
      if (x.p[i] > largest.value) largest = {x.p[i], i};
    }
    return largest;
  } else {
    return max_of_marked(x);
  }
}

}  // namespace detail

/// Row i of A.
template <class T, int R, int C>
lanes<T, C> row(const matrix<T, R, C>& A, int i) {
  return lanes<T, C>([&](int j) PASSIVE_HAPTICS_INLINE { return apart(A(i, j)); });
}

/// Returns A x.
template <class T, int R, int C>
vector<T, R> times(const matrix<T, R, C>& A, const vector<T, C>& x) {
  const auto column = [&](int j) PASSIVE_HAPTICS_INLINE {
    return lanes<T, R>([&](int i) PASSIVE_HAPTICS_INLINE { return A(i, j); });
  };
  lanes<T, R> y = column(0) * apart(x[0]);
  unrolled<C - 1>([&](auto j) PASSIVE_HAPTICS_INLINE { y = y + column(j + 1) * apart(x[j + 1]); });
  return y;
}

/// Returns A^T x.
template <class T, int R, int C>
vector<T, C> transposed_times(const matrix<T, R, C>& A, const vector<T, R>& x) {
  lanes<T, C> y = row(A, 0) * apart(x[0]);
  unrolled<R - 1>([&](auto i) PASSIVE_HAPTICS_INLINE { y = y + row(A, i + 1) * apart(x[i + 1]); });
  return y;
}

/// Returns A^T B.
template <class T, int R, int Columns, int C>
  requires(C > 1)
matrix<T, Columns, C> transposed_times(const matrix<T, R, Columns>& A, const matrix<T, R, C>& B) {
  matrix<T, Columns, C> AtB;
  unrolled<C>([&](auto j) PASSIVE_HAPTICS_INLINE { AtB.col(j) = transposed_times(A, column(B, j)); });
  return AtB;
}

/// Returns A B.
template <class T, int R, int K, int C>
matrix<T, R, C> times(const matrix<T, R, K>& A, const matrix<T, K, C>& B) {
  matrix<T, R, C> AB;
  unrolled<R>([&](auto i) PASSIVE_HAPTICS_INLINE {
    const vector<T, C> y = transposed_times(B, vector<T, K>(A.row(i)));
    unrolled<C>([&](auto j) PASSIVE_HAPTICS_INLINE { AB(i, j) = y[j]; });
  });
  return AB;
}

/// Returns A B, one of them diagonal.
template <class A, class B>
auto times(const A& a, const B& b) {
  return (a * b).eval();
}

}  // namespace passive_haptics
