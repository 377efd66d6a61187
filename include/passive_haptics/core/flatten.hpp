/// @file
/// All of a control cycle as one function.
#pragma once

/// Before a function: what it calls is inlined into it, whatever its size. Only where assertions are off: a
/// debug build would take the compiler three times as long for nothing. Define it as nothing for a program
/// that would rather compile in two thirds of the time.
#if defined(PASSIVE_HAPTICS_FLATTEN)
#elif defined(NDEBUG) && defined(__GNUC__)
#define PASSIVE_HAPTICS_FLATTEN [[gnu::flatten]]
#else
#define PASSIVE_HAPTICS_FLATTEN
#endif

/// Before the body of a lambda: it is inlined as well where clang++, which flattens one level, would call it.
#define PASSIVE_HAPTICS_INLINE __attribute__((always_inline))
