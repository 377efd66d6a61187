/// @file
/// All of a control cycle as one function.
#pragma once

/// Before a function: what it calls is inlined into it, whatever its size. Only where assertions are off: a debug build would
/// take the compiler three times as long for nothing.
#if defined(NDEBUG) && defined(__GNUC__)
#define PASSIVE_HAPTICS_FLATTEN [[gnu::flatten]]
#else
#define PASSIVE_HAPTICS_FLATTEN
#endif
