/// Inlining of a whole control cycle into one function, and unrolled loops over compile-time sizes.
#pragma once

#include <utility>

/// Inlines the function or the body of a lambda that it precedes. Only in builds without assertions: with
/// sanitizers, a debug build would take a fifth longer to compile.
#ifdef NDEBUG
#define PASSIVE_HAPTICS_INLINE __attribute__((always_inline))
#else
#define PASSIVE_HAPTICS_INLINE
#endif
/// Inlines all calls of the function that it precedes. Only in builds without assertions: in a debug build it
/// would triple the compile time. Define it as empty to compile in two thirds of the time.
#if !defined(PASSIVE_HAPTICS_FLATTEN) && defined(NDEBUG) && defined(__GNUC__)
#define PASSIVE_HAPTICS_FLATTEN [[gnu::flatten]]
#if defined(__clang__)
/// Precedes the parts of a flattened function, because clang++ flattens only one level.
#define PASSIVE_HAPTICS_PART PASSIVE_HAPTICS_INLINE inline
#endif
#elif !defined(PASSIVE_HAPTICS_FLATTEN)
#define PASSIVE_HAPTICS_FLATTEN
#endif
#if !defined(PASSIVE_HAPTICS_FLATTEN_COMMANDS)
/// As PASSIVE_HAPTICS_FLATTEN, for batches of commands, if a program waits for these only.
#define PASSIVE_HAPTICS_FLATTEN_COMMANDS PASSIVE_HAPTICS_FLATTEN
#endif
#if !defined(PASSIVE_HAPTICS_PART)
/// Precedes the parts of a flattened function, because clang++ flattens only one level.
#define PASSIVE_HAPTICS_PART
#endif

namespace passive_haptics {

/// Calls f(0), ..., f(N - 1). Loops that are not unrolled, as at -O2, take a third of a control cycle.
template <int N, class F>
PASSIVE_HAPTICS_INLINE constexpr void unrolled(F&& f) {
  [&]<int... Index>(std::integer_sequence<int, Index...>)
      PASSIVE_HAPTICS_INLINE { (f(Index), ...); }(std::make_integer_sequence<int, N>());
}

}  // namespace passive_haptics
