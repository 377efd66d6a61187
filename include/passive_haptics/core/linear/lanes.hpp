/// N numbers in registers, with branch-free selection.
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

/// Returns x, loaded separately: clang++ would load the next number, too, and stall if it was just stored.
template <class T>
PASSIVE_HAPTICS_INLINE inline T apart(T x) {
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

/// N numbers, such as one per brake, with element-wise operations. Selections between lanes have no branch,
/// because conditions such as slipping brakes are unpredictable. For intermediate values; store results in
/// vectors. Fast if the caller is PASSIVE_HAPTICS_FLATTEN, because the numbers then stay in registers. Types
/// other than float and double are computed one by one.
template <class T, int N>
struct lanes {
  using packet = typename detail::packet_of<T>::type;  ///< A register of T.
  using mask = lane_mask<T, N>;                        ///< Result of a comparison.
  static constexpr int width = mask::width;            ///< Numbers per register.
  static constexpr int count = mask::count;            ///< Number of registers.
  static constexpr int rest = N % width;               ///< Numbers in the last register, if it is not full.
  packet p[std::size_t(count)];                        ///< The numbers, padded with zeros.

  lanes() = default;
  /// Sets all lanes, including the unused ones, to x.
  PASSIVE_HAPTICS_INLINE lanes(T x) {
    unrolled<count>([&](auto k) PASSIVE_HAPTICS_INLINE {
      if constexpr (width == 1) p[k] = x;
      else if constexpr (width == 2) p[k] = packet{x, x};
      else p[k] = packet{x, x, x, x};
    });
  }
  /// f(0), ..., f(N - 1), padded with zeros.
  template <class F>
    requires std::is_invocable_r_v<T, F, int>
  PASSIVE_HAPTICS_INLINE explicit lanes(const F& f) {
    unrolled<count>([&](auto k) PASSIVE_HAPTICS_INLINE {
      const auto number = [&](int i)
                              PASSIVE_HAPTICS_INLINE { return k * width + i < N ? f(k * width + i) : T(0); };
      if constexpr (width == 1) p[k] = f(k);
      else if constexpr (width == 2) p[k] = packet{number(0), number(1)};
      else p[k] = packet{number(0), number(1), number(2), number(3)};
    });
  }
  /// Copies a vector number by number: loading a packet would stall on numbers that were just stored
  /// separately. Uses apart() if the vector does not fill a register, as another one may follow in memory.
  lanes(const vector<T, N>& x)
      : lanes([&](int i) PASSIVE_HAPTICS_INLINE { return N < width ? apart(x[i]) : x[i]; }) {}

  /// Loads x[0], ..., x[N - 1] from any address. Slow if they were stored separately just before.
  PASSIVE_HAPTICS_INLINE static lanes load(const T* x) {
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
  /// Stores x[0], ..., x[N - 1] at any address.
  PASSIVE_HAPTICS_INLINE void store(T* x) const {
    unrolled<N / width>([&](auto k)
                            PASSIVE_HAPTICS_INLINE { std::memcpy(x + k * width, &p[k], sizeof(packet)); });
    if constexpr (rest != 0)
      unrolled<rest>([&](auto i) PASSIVE_HAPTICS_INLINE { x[N - rest + i] = p[count - 1][i]; });
  }
  /// Converts to a vector.
  PASSIVE_HAPTICS_INLINE operator vector<T, N>() const {
    vector<T, N> x;  // not by store(): g++ would keep x in memory
    unrolled<N / width>(
        [&](auto k) PASSIVE_HAPTICS_INLINE { std::memcpy(x.data() + k * width, &p[k], sizeof(packet)); });
    if constexpr (rest != 0)
      unrolled<rest>([&](auto i) PASSIVE_HAPTICS_INLINE { x[N - rest + i] = p[count - 1][i]; });
    return x;
  }
  /// Lane i.
  PASSIVE_HAPTICS_INLINE T operator[](int i) const {
    if constexpr (width == 1) return p[i];
    else return p[i / width][i % width];
  }

  /// @cond
  // Applies f to each packet
  template <class F>
  PASSIVE_HAPTICS_INLINE static lanes each(F&& f) {
    lanes x;
    unrolled<count>([&](auto k) PASSIVE_HAPTICS_INLINE { x.p[k] = f(k); });
    return x;
  }
  template <class F>
  PASSIVE_HAPTICS_INLINE static mask test(F&& f) {
    mask x;
    unrolled<count>([&](auto k) PASSIVE_HAPTICS_INLINE {
      x.p[k] = detail::bit_cast<typename detail::truths_of<T>::type>(f(k));
    });
    return x;
  }

  PASSIVE_HAPTICS_INLINE friend lanes operator-(const lanes& a) {
    return each([&](auto k) PASSIVE_HAPTICS_INLINE { return -a.p[k]; });
  }
  PASSIVE_HAPTICS_INLINE friend lanes operator+(const lanes& a, const lanes& b) {
    return each([&](auto k) PASSIVE_HAPTICS_INLINE { return a.p[k] + b.p[k]; });
  }
  PASSIVE_HAPTICS_INLINE friend lanes operator-(const lanes& a, const lanes& b) {
    return each([&](auto k) PASSIVE_HAPTICS_INLINE { return a.p[k] - b.p[k]; });
  }
  PASSIVE_HAPTICS_INLINE friend lanes operator*(const lanes& a, const lanes& b) {
    return each([&](auto k) PASSIVE_HAPTICS_INLINE { return a.p[k] * b.p[k]; });
  }
  PASSIVE_HAPTICS_INLINE friend lanes operator/(const lanes& a, const lanes& b) {
    return each([&](auto k) PASSIVE_HAPTICS_INLINE { return a.p[k] / b.p[k]; });
  }
  PASSIVE_HAPTICS_INLINE lanes& operator+=(const lanes& x) { return *this = *this + x; }
  PASSIVE_HAPTICS_INLINE lanes& operator-=(const lanes& x) { return *this = *this - x; }
  PASSIVE_HAPTICS_INLINE friend mask operator<(const lanes& a, const lanes& b) {
    return test([&](auto k) PASSIVE_HAPTICS_INLINE { return a.p[k] < b.p[k]; });
  }
  PASSIVE_HAPTICS_INLINE friend mask operator<=(const lanes& a, const lanes& b) {
    return test([&](auto k) PASSIVE_HAPTICS_INLINE { return a.p[k] <= b.p[k]; });
  }
  PASSIVE_HAPTICS_INLINE friend mask operator>(const lanes& a, const lanes& b) { return b < a; }
  PASSIVE_HAPTICS_INLINE friend mask operator>=(const lanes& a, const lanes& b) { return b <= a; }
  /// @endcond
};
/// Lanes of a vector.
template <class T, int N>
lanes(const vector<T, N>&) -> lanes<T, N>;

/// Returns a in the lanes that are set, else b.
template <class T, int N>
PASSIVE_HAPTICS_INLINE inline lanes<T, N> select(const lane_mask<T, N>& where,
                                                 const std::type_identity_t<lanes<T, N>>& a,
                                                 const std::type_identity_t<lanes<T, N>>& b) {
  return lanes<T, N>::each([&](auto k) PASSIVE_HAPTICS_INLINE {
    const auto& m = where.p[k];
    if constexpr (lanes<T, N>::width == 1) return m ? a.p[k] : b.p[k];
    else return detail::merged(m, a.p[k], b.p[k]);
  });
}

/// Magnitude of y with the sign of x.
template <class T, int N>
PASSIVE_HAPTICS_INLINE inline lanes<T, N> copysign(const std::type_identity_t<lanes<T, N>>& y,
                                                   const lanes<T, N>& x) {
  return lanes<T, N>::each([&](auto k) PASSIVE_HAPTICS_INLINE {
    if constexpr (lanes<T, N>::width == 1) return std::copysign(y.p[k], x.p[k]);
    else return detail::with_sign_of(x.p[k], y.p[k]);
  });
}

/// Absolute value.
template <class T, int N>
PASSIVE_HAPTICS_INLINE inline lanes<T, N> abs(const lanes<T, N>& x) {
  return copysign(x, lanes<T, N>(T(0)));
}

/// Square root, branch-free for doubles: std::sqrt may set errno. (Eigen's for floats is approximate.)
template <class T, int N>
lanes<T, N> sqrt(const lanes<T, N>& x) {
  if constexpr (std::same_as<T, double>) return vector<T, N>(vector<T, N>(x).cwiseSqrt());
  else return lanes<T, N>([&](int i) PASSIVE_HAPTICS_INLINE { return std::sqrt(x[i]); });
}

/// Sign: -1, 0 or 1; 0 for NaN.
template <class T, int N>
lanes<T, N> sgn(const lanes<T, N>& x) {
  return select(abs(x) > T(0), copysign(T(1), x), T(0));
}

/// Element-wise minimum; a if either is NaN.
template <class T, int N>
PASSIVE_HAPTICS_INLINE inline lanes<T, N> min(const lanes<T, N>& a,
                                              const std::type_identity_t<lanes<T, N>>& b) {
  return lanes<T, N>::each([&](auto k) PASSIVE_HAPTICS_INLINE { return b.p[k] < a.p[k] ? b.p[k] : a.p[k]; });
}

/// Element-wise maximum; a if either is NaN.
template <class T, int N>
PASSIVE_HAPTICS_INLINE inline lanes<T, N> max(const lanes<T, N>& a,
                                              const std::type_identity_t<lanes<T, N>>& b) {
  return lanes<T, N>::each([&](auto k) PASSIVE_HAPTICS_INLINE { return a.p[k] < b.p[k] ? b.p[k] : a.p[k]; });
}

/// Clamps x to [lowest, highest] without a branch.
template <class T>
PASSIVE_HAPTICS_INLINE inline T clamped(T x, T lowest, T highest) {
  return max(min(lanes<T, 1>(x), highest), lowest)[0];
}

/// Returns (x_0 + x_1, y_0 + y_1).
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
