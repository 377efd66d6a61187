/// @file
/// Loops over compile-time sizes, unrolled at every optimisation level.
#pragma once

#include <passive_haptics/core/flatten.hpp>

#include <utility>

namespace passive_haptics {

/// f(0), f(1), ..., f(N - 1), for small N. Compilers leave such loops rolled at -O2, which costs a third of a
/// control cycle.
template <int N, class F>
[[gnu::always_inline]] constexpr void unrolled(F&& f) {
  [&]<int... Index>(std::integer_sequence<int, Index...>)
      PASSIVE_HAPTICS_INLINE { (f(Index), ...); }(std::make_integer_sequence<int, N>());
}

namespace detail {
// W times the same number. Not 0 + x, which is another number where x is -0.
template <class Register, class T, int... K>
[[gnu::always_inline]] constexpr Register repeated(T x, std::integer_sequence<int, K...>) {
  return Register{(static_cast<void>(K), x)...};
}
template <class Register, class T>
[[gnu::always_inline]] constexpr Register repeated(T x) {
  return repeated<Register>(x, std::make_integer_sequence<int, sizeof(Register) / sizeof(T)>());
}
}  // namespace detail

}  // namespace passive_haptics
