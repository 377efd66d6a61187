/// @file
/// Lists of requirements, one for each concept, which explain what a type lacks.
#pragma once

namespace passive_haptics {

/// Last template argument of a list of requirements: the first requirement that is not met is then an error
/// of the compiler with its message. Without it the list is the concept, and gives no message:
///
///     static_assert(Mechanism<arm>);               // "... evaluated to false"
///     static_assert(is_mechanism<arm, explain>());  // "the mechanism needs ..."
///
/// A list returns true after its message, so that one mistake is one error.
inline constexpr bool explain = true;

}  // namespace passive_haptics
