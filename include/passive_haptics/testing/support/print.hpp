/// @file
/// GoogleTest prints the library's enumerations in words.
#pragma once

#include <passive_haptics/core/status.hpp>
#include <passive_haptics/force/classification.hpp>

#include <ostream>

namespace passive_haptics {

/// Prints a status in a test's failure.
inline void PrintTo(status s, std::ostream* out) { *out << to_string(s); }
/// Prints a power class in a test's failure.
inline void PrintTo(power_class c, std::ostream* out) { *out << to_string(c); }
/// Prints a display class in a test's failure.
inline void PrintTo(display_class c, std::ostream* out) { *out << to_string(c); }

}  // namespace passive_haptics
