/// @file
/// All of a control cycle as one function.
#pragma once

/// Before a function: what it calls is inlined into it, whatever its size. Only where assertions are off: in
/// a debug build it would triple the compiler's time for nothing. A program that defines it as nothing
/// compiles in two thirds of the time.
#if defined(PASSIVE_HAPTICS_FLATTEN)
#elif defined(NDEBUG) && defined(__GNUC__)
#define PASSIVE_HAPTICS_FLATTEN [[gnu::flatten]]
#else
#define PASSIVE_HAPTICS_FLATTEN
#endif

/// Before the body of a lambda: it is inlined as well. clang++ flattens one level only.
#define PASSIVE_HAPTICS_INLINE __attribute__((always_inline))
