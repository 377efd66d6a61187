/// @file
/// A value's bits as a value of another type.
#pragma once

#include <type_traits>

namespace passive_haptics::detail {

/// std::bit_cast, which libc++ 13 (Emscripten 3.1) and older do not have.
template <class To, class From>
constexpr To bit_cast(const From& x) noexcept {
  static_assert(sizeof(To) == sizeof(From) && std::is_trivially_copyable_v<To>);
  return __builtin_bit_cast(To, x);
}

}  // namespace passive_haptics::detail
