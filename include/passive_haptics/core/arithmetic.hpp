/// Floating-point requirements, named tolerances, signs and selections.
#pragma once

#include <cfloat>
#include <cstdint>
#include <limits>
#include <numbers>
#include <type_traits>

// -ffinite-math-only removes the tests for NaN and gives wrong sign regions.
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__) || defined(_M_FP_FAST)
#error "passive_haptics needs IEEE arithmetic: compile this file without -ffast-math / -ffinite-math-only."
#endif
// These flags exceed the tolerances. docs/numerics.md lists flags that a header cannot detect.
#if defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__)
#error "passive_haptics needs IEEE arithmetic: compile without -fassociative-math / -freciprocal-math."
#endif

// x87 keeps excess precision, so adding 1.5 * 2^52 does not round to an integer.
#if FLT_EVAL_METHOD != 0 && FLT_EVAL_METHOD != 16
#error "passive_haptics needs float and double as they are: on 32-bit x86 compile with -msse2 -mfpmath=sse."
#endif

namespace passive_haptics {

namespace detail {
/// std::bit_cast is missing from libc++ 13 (Emscripten 3.1) and older.
template <class To, class From>
constexpr To bit_cast(const From& x) noexcept {
  static_assert(sizeof(To) == sizeof(From) && std::is_trivially_copyable_v<To>);
  return __builtin_bit_cast(To, x);
}
}  // namespace detail

/// Rounding error of a sum of n products, relative to the norms of its data: 4 n eps.
template <class T>
constexpr T rounding_tolerance(int n) {
  return static_cast<T>(4 * n) * std::numeric_limits<T>::epsilon();
}

/// Converts degrees to radians. If a macro has the same name, as on Arduino, write `(radians)(angle)`.
template <class T>
constexpr T(radians)(T degrees) {
  return degrees * (std::numbers::pi_v<T> / T(180));
}

/// Converts radians to degrees. If a macro has the same name, as on Arduino, write `(degrees)(angle)`.
template <class T>
constexpr T(degrees)(T radians) {
  return radians * (T(180) / std::numbers::pi_v<T>);
}

/// Sign of x: -1, 0 or 1; 0 for NaN.
template <class T>
constexpr T sgn(T x) {
  return static_cast<T>((x > T(0)) - (x < T(0)));
}

/// Returns `where ? a : b` for numbers or enumerators without a branch, also with clang++.
template <class X>
  requires(std::is_arithmetic_v<X> || std::is_enum_v<X>)
X select(bool where, X a, X b) {
  if constexpr (sizeof(X) > sizeof(std::uint64_t)) {
    return where ? a : b;
  } else {
    using bits = std::conditional_t<sizeof(X) == sizeof(std::uint64_t), std::uint64_t, std::uint32_t>;
    const auto x = detail::bit_cast<bits>(a), y = detail::bit_cast<bits>(b);
    bits mask = -static_cast<bits>(where);
#if defined(__clang__)
    asm("" : "+r"(mask));
#endif
    return detail::bit_cast<X>(y ^ ((x ^ y) & mask));
  }
}

}  // namespace passive_haptics
