/// @file
/// What the library requires of floating-point arithmetic, its named tolerances, signs and choices; and what
/// a formula makes of its scalar, which is a number or a pack of them (core/scalar/pack.hpp).
#pragma once

#include <cfloat>
#include <cstdint>
#include <limits>
#include <numbers>
#include <type_traits>

// With -ffinite-math-only the tests for NaN are compiled away and sign regions come out wrong.
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__) || defined(_M_FP_FAST)
#error "passive_haptics needs IEEE arithmetic: compile this file without -ffast-math / -ffinite-math-only."
#endif
// These round in another way than the tolerances allow. docs/numerics.md lists flags that no header can see.
#if defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__)
#error "passive_haptics needs IEEE arithmetic: compile without -fassociative-math / -freciprocal-math."
#endif

// x87 rounds to no type's own precision: what adds 1.5 * 2^52 to round to an integer gets another number.
#if FLT_EVAL_METHOD != 0 && FLT_EVAL_METHOD != 16
#error "passive_haptics needs float and double as they are: on 32-bit x86 compile with -msse2 -mfpmath=sse."
#endif

namespace passive_haptics {

namespace detail {
/// std::bit_cast, which libc++ 13 (Emscripten 3.1) and older do not have.
template <class To, class From>
constexpr To bit_cast(const From& x) noexcept {
  static_assert(sizeof(To) == sizeof(From) && std::is_trivially_copyable_v<To>);
  return __builtin_bit_cast(To, x);
}

/// Bits of two registers: those of x where m is set, else those of y.
template <class Register, class Bits>
[[gnu::always_inline]] inline Register merged(const Bits& m, const Register& x, const Register& y) {
  return bit_cast<Register>((bit_cast<Bits>(x) & m) | (bit_cast<Bits>(y) & ~m));
}
}  // namespace detail

/// Rounding of a sum of n products, relative to the norms of its data: 4 n eps. Smaller values cannot be
/// distinguished from zero.
template <class T>
constexpr T rounding_tolerance(int n) {
  return static_cast<T>(4 * n) * std::numeric_limits<T>::epsilon();
}

/// Radians of an angle given in degrees. Where a macro has this name, as Arduino's has, write
/// `(radians)(angle)`.
template <class T>
constexpr T(radians)(T degrees) {
  return degrees * (std::numbers::pi_v<T> / T(180));
}

/// Degrees of an angle given in radians. Where a macro has this name, as Arduino's has, write
/// `(degrees)(angle)`.
template <class T>
constexpr T(degrees)(T radians) {
  return radians * (T(180) / std::numbers::pi_v<T>);
}

/// Sign of x: -1, 0 or 1. Of NaN it is 0.
template <class T>
constexpr T sgn(T x) {
  return static_cast<T>((x > T(0)) - (x < T(0)));
}

/// Branch-free `where ? a : b` of a number or enumerator; the asm keeps clang++ from turning it back into a
/// branch.
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

namespace detail {
// A single number. core/scalar/pack.hpp has that of packs.
template <class T>
struct scalar_parts {
  using number = T;
  using truth = bool;
  template <class X>
  using choice = X;
};

// a where it is true, else b: of numbers, registers or packs.
template <class Truth, class X>
[[gnu::always_inline]] constexpr X one_of(Truth where, X a, X b) {
  if constexpr (requires { where ? a : b; }) return where ? a : b;
  else return select(where, a, b);
}
}  // namespace detail

/// T, or of a pack the type of each of its numbers: parameters are single numbers in either case.
template <class T>
using number_of = typename detail::scalar_parts<T>::number;
/// What comparing two T gives: bool, or a truth for each number of a pack.
template <class T>
using truth_of = typename detail::scalar_parts<T>::truth;
/// An enumerator of X that numbers T decide: X, or one for each number of a pack.
template <class T, class X>
using choice_of = typename detail::scalar_parts<T>::template choice<X>;

/// True if it is false.
constexpr bool none(bool where) { return !where; }

/// What says of itself `static constexpr bool branch_free = true`: a mechanism, shape or law whose functions
/// are templates over the scalar without a branch, so that they take packs (control/batch).
template <class X>
concept BranchFree = requires { requires X::branch_free; };

}  // namespace passive_haptics
