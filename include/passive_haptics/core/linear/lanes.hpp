/// @file
/// N numbers at once, and choices between them that no branch makes.
#pragma once

#include <passive_haptics/core/arithmetic.hpp>
#include <passive_haptics/core/flatten.hpp>
#include <passive_haptics/core/linear/lane_mask.hpp>
#include <passive_haptics/core/matrix.hpp>

#include <cmath>
#include <cstring>
#include <type_traits>
#include <utility>

namespace passive_haptics {

/// x, read alone. clang++ would read a number that goes to a lane together with what stands behind it:
/// numbers that were just stored alone, or as two columns of a matrix, would then wait for each other.
template <class T>
[[gnu::always_inline]] inline T apart(T x) {
#if defined(__clang__) && (defined(__SSE2__) || defined(__aarch64__))
  if constexpr (detail::packet_width<T> > 1) {
#if defined(__aarch64__)
    asm("" : "+w"(x));
#else
    asm("" : "+x"(x));
#endif
  }
#endif
  return x;
}

/// N numbers, such as one for each brake. What is written of them holds of each. Which brake slips, or is
/// released, no processor can predict: a choice between lanes takes the same time whichever it is.
///
/// For a function that calculates; vectors hold what stays. Fast where the caller is PASSIVE_HAPTICS_FLATTEN:
/// the numbers then live in registers. Other types than float and double are computed one by one.
template <class T, int N>
struct lanes {
  using packet = typename detail::packet_of<T>::type;  ///< A register of T.
  using mask = lane_mask<T, N>;                        ///< What a comparison gives.
  static constexpr int width = mask::width;            ///< Numbers of a register.
  static constexpr int count = mask::count;            ///< Registers.
  static constexpr int rest = N % width;               ///< Numbers in the last one, if it is not full.
  packet p[std::size_t(count)];                        ///< The numbers, and zeros beyond.

  lanes() = default;
  /// N times the same number, also beyond the last.
  [[gnu::always_inline]] lanes(T x) {
    unrolled<count>([&](auto k) PASSIVE_HAPTICS_INLINE {
      if constexpr (width == 1) p[k] = x;
      else if constexpr (width == 2) p[k] = packet{x, x};
      else p[k] = packet{x, x, x, x};
    });
  }
  /// f(0), ..., f(N - 1), and zeros beyond.
  template <class F>
    requires std::is_invocable_r_v<T, F, int>
  [[gnu::always_inline]] explicit lanes(const F& f) {
    unrolled<count>([&](auto k) PASSIVE_HAPTICS_INLINE {
      const auto number = [&](int i)
                              PASSIVE_HAPTICS_INLINE { return k * width + i < N ? f(k * width + i) : T(0); };
      if constexpr (width == 1) p[k] = f(k);
      else if constexpr (width == 2) p[k] = packet{number(0), number(1)};
      else p[k] = packet{number(0), number(1), number(2), number(3)};
    });
  }
  /// The numbers of a vector. One by one: a load of a packet would wait for numbers that were stored alone.
  /// Fewer than fill a register are read apart, as what stands behind them may be another vector.
  lanes(const vector<T, N>& x)
      : lanes([&](int i) PASSIVE_HAPTICS_INLINE { return N < width ? apart(x[i]) : x[i]; }) {}

  /// x[0], ..., x[N - 1], at any address, of numbers that were not stored just now.
  [[gnu::always_inline]] static lanes load(const T* x) {
    lanes a;
    unrolled<N / width>([&](auto k)
                            PASSIVE_HAPTICS_INLINE { std::memcpy(&a.p[k], x + k * width, sizeof(packet)); });
    if constexpr (rest != 0) {
      [&]<int... Index>(std::integer_sequence<int, Index...>) {
        a.p[count - 1] = packet{x[N - rest + Index]...};
      }(std::make_integer_sequence<int, rest>());
    }
    return a;
  }
  /// Stores x[0], ..., x[N - 1].
  [[gnu::always_inline]] void store(T* x) const {
    unrolled<N / width>([&](auto k)
                            PASSIVE_HAPTICS_INLINE { std::memcpy(x + k * width, &p[k], sizeof(packet)); });
    if constexpr (rest != 0)
      unrolled<rest>([&](auto i) PASSIVE_HAPTICS_INLINE { x[N - rest + i] = p[count - 1][i]; });
  }
  /// As a vector.
  [[gnu::always_inline]] operator vector<T, N>() const {
    vector<T, N> x;  // not by store(): g++ then keeps x in memory
    unrolled<N / width>(
        [&](auto k) PASSIVE_HAPTICS_INLINE { std::memcpy(x.data() + k * width, &p[k], sizeof(packet)); });
    if constexpr (rest != 0)
      unrolled<rest>([&](auto i) PASSIVE_HAPTICS_INLINE { x[N - rest + i] = p[count - 1][i]; });
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
    unrolled<count>([&](auto k) PASSIVE_HAPTICS_INLINE { x.p[k] = f(k); });
    return x;
  }
  template <class F>
  [[gnu::always_inline]] static mask test(F&& f) {
    mask x;
    unrolled<count>([&](auto k) PASSIVE_HAPTICS_INLINE {
      x.p[k] = detail::bit_cast<typename detail::truths_of<T>::type>(f(k));
    });
    return x;
  }

  [[gnu::always_inline]] friend lanes operator-(const lanes& a) {
    return each([&](auto k) PASSIVE_HAPTICS_INLINE { return -a.p[k]; });
  }
  [[gnu::always_inline]] friend lanes operator+(const lanes& a, const lanes& b) {
    return each([&](auto k) PASSIVE_HAPTICS_INLINE { return a.p[k] + b.p[k]; });
  }
  [[gnu::always_inline]] friend lanes operator-(const lanes& a, const lanes& b) {
    return each([&](auto k) PASSIVE_HAPTICS_INLINE { return a.p[k] - b.p[k]; });
  }
  [[gnu::always_inline]] friend lanes operator*(const lanes& a, const lanes& b) {
    return each([&](auto k) PASSIVE_HAPTICS_INLINE { return a.p[k] * b.p[k]; });
  }
  [[gnu::always_inline]] friend lanes operator/(const lanes& a, const lanes& b) {
    return each([&](auto k) PASSIVE_HAPTICS_INLINE { return a.p[k] / b.p[k]; });
  }
  [[gnu::always_inline]] lanes& operator+=(const lanes& x) { return *this = *this + x; }
  [[gnu::always_inline]] lanes& operator-=(const lanes& x) { return *this = *this - x; }
  [[gnu::always_inline]] friend mask operator<(const lanes& a, const lanes& b) {
    return test([&](auto k) PASSIVE_HAPTICS_INLINE { return a.p[k] < b.p[k]; });
  }
  [[gnu::always_inline]] friend mask operator<=(const lanes& a, const lanes& b) {
    return test([&](auto k) PASSIVE_HAPTICS_INLINE { return a.p[k] <= b.p[k]; });
  }
  [[gnu::always_inline]] friend mask operator>(const lanes& a, const lanes& b) { return b < a; }
  [[gnu::always_inline]] friend mask operator>=(const lanes& a, const lanes& b) { return b <= a; }
  /// @endcond
};
/// Of a vector.
template <class T, int N>
lanes(const vector<T, N>&) -> lanes<T, N>;

/// a where it is true, else b.
template <class T, int N>
[[gnu::always_inline]] inline lanes<T, N> select(const lane_mask<T, N>& where,
                                                 const std::type_identity_t<lanes<T, N>>& a,
                                                 const std::type_identity_t<lanes<T, N>>& b) {
  return lanes<T, N>::each([&](auto k) PASSIVE_HAPTICS_INLINE {
    const auto& m = where.p[k];
    if constexpr (lanes<T, N>::width == 1) return m ? a.p[k] : b.p[k];
    else return detail::merged(m, a.p[k], b.p[k]);
  });
}

/// y with the sign of x.
template <class T, int N>
[[gnu::always_inline]] inline lanes<T, N> copysign(const std::type_identity_t<lanes<T, N>>& y,
                                                   const lanes<T, N>& x) {
  return lanes<T, N>::each([&](auto k) PASSIVE_HAPTICS_INLINE {
    if constexpr (lanes<T, N>::width == 1) return std::copysign(y.p[k], x.p[k]);
    else return detail::with_sign_of(x.p[k], y.p[k]);
  });
}

/// |x|
template <class T, int N>
[[gnu::always_inline]] inline lanes<T, N> abs(const lanes<T, N>& x) {
  return copysign(x, lanes<T, N>(T(0)));
}

/// The root. Of doubles without a branch: std::sqrt has one, to set errno where x < 0. (Eigen's of four
/// floats is an approximation.)
template <class T, int N>
lanes<T, N> sqrt(const lanes<T, N>& x) {
  if constexpr (std::same_as<T, double>) return vector<T, N>(vector<T, N>(x).cwiseSqrt());
  else return lanes<T, N>([&](int i) PASSIVE_HAPTICS_INLINE { return std::sqrt(x[i]); });
}

/// -1, 0 or 1; 0 for NaN.
template <class T, int N>
lanes<T, N> sgn(const lanes<T, N>& x) {
  return select(abs(x) > T(0), copysign(T(1), x), T(0));
}

/// The smaller of each two; a where one is NaN.
template <class T, int N>
[[gnu::always_inline]] inline lanes<T, N> min(const lanes<T, N>& a,
                                              const std::type_identity_t<lanes<T, N>>& b) {
  return lanes<T, N>::each([&](auto k) PASSIVE_HAPTICS_INLINE { return b.p[k] < a.p[k] ? b.p[k] : a.p[k]; });
}

/// The larger of each two; a where one is NaN.
template <class T, int N>
[[gnu::always_inline]] inline lanes<T, N> max(const lanes<T, N>& a,
                                              const std::type_identity_t<lanes<T, N>>& b) {
  return lanes<T, N>::each([&](auto k) PASSIVE_HAPTICS_INLINE { return a.p[k] < b.p[k] ? b.p[k] : a.p[k]; });
}

/// x within [lowest, highest], without a branch.
template <class T>
[[gnu::always_inline]] inline T clamped(T x, T lowest, T highest) {
  return max(min(lanes<T, 1>(x), highest), lowest)[0];
}

/// (x_0 + x_1, y_0 + y_1), added crosswise.
template <class T>
lanes<T, 2> horizontal_add(const lanes<T, 2>& x, const lanes<T, 2>& y) {
  if constexpr (lanes<T, 2>::width != 2)
    return lanes<T, 2>([&](int i) PASSIVE_HAPTICS_INLINE { return i == 0 ? x[0] + x[1] : y[0] + y[1]; });
  else
    return lanes<T, 2>::each([&](auto k) PASSIVE_HAPTICS_INLINE {
      return __builtin_shufflevector(x.p[k], y.p[k], 0, 2) + __builtin_shufflevector(x.p[k], y.p[k], 1, 3);
    });
}

}  // namespace passive_haptics
