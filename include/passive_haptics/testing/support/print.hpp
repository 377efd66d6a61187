/// Text of the library's enumerations in GoogleTest failures.
#pragma once

#include <passive_haptics/core/status.hpp>
#include <passive_haptics/force/classification.hpp>

#include <ostream>

namespace passive_haptics {

/// As text.
inline void PrintTo(status s, std::ostream* out) { *out << to_string(s); }
/// As text.
inline void PrintTo(power_class c, std::ostream* out) { *out << to_string(c); }
/// As text.
inline void PrintTo(display_class c, std::ostream* out) { *out << to_string(c); }

}  // namespace passive_haptics
