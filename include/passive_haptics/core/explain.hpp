/// Explanation of unmet requirements, for lists of requirements of a concept.
#pragma once

namespace passive_haptics {

/// Last template argument of a list of requirements, such as is_mechanism: the compiler then reports the
/// first unmet requirement with its message. Without it, the list is the concept and gives no message:
///
///     static_assert(Mechanism<arm>);               // "... evaluated to false"
///     static_assert(is_mechanism<arm, explain>());  // "the mechanism needs ..."
///
/// A list returns true after its message, so that one mistake gives one error.
inline constexpr bool explain = true;

}  // namespace passive_haptics
