/// @file
/// All of a control cycle as one function: what it calls is inlined, loops over compile-time sizes are
/// unrolled.
#pragma once

#include <utility>

/// Before a function: what it calls is inlined into it, whatever its size. Only where assertions are off: in
/// a debug build it would triple the compiler's time for nothing. A program that defines it as nothing
/// compiles in two thirds of the time.
#if !defined(PASSIVE_HAPTICS_FLATTEN) && defined(NDEBUG) && defined(__GNUC__)
#define PASSIVE_HAPTICS_FLATTEN [[gnu::flatten]]
#if defined(__clang__)
/// Before the parts of such a function: clang++ flattens one level only.
#define PASSIVE_HAPTICS_PART [[gnu::always_inline]] inline
#endif
#elif !defined(PASSIVE_HAPTICS_FLATTEN)
#define PASSIVE_HAPTICS_FLATTEN
#endif
#if !defined(PASSIVE_HAPTICS_PART)
/// Before the parts of such a function: clang++ flattens one level only.
#define PASSIVE_HAPTICS_PART
#endif

/// Before the body of a lambda: it is inlined as well.
#define PASSIVE_HAPTICS_INLINE __attribute__((always_inline))

namespace passive_haptics {

/// f(0), f(1), ..., f(N - 1), for small N. Compilers leave such loops rolled at -O2, which costs a third of a
/// control cycle.
template <int N, class F>
[[gnu::always_inline]] constexpr void unrolled(F&& f) {
  [&]<int... Index>(std::integer_sequence<int, Index...>)
      PASSIVE_HAPTICS_INLINE { (f(Index), ...); }(std::make_integer_sequence<int, N>());
}

}  // namespace passive_haptics
