/// @file
/// An element of an array by a number that may be signed.
#pragma once

#include <cstddef>

namespace passive_haptics {

namespace detail {

struct nth_element {
  template <class Array, class Number>
  [[gnu::always_inline]] constexpr decltype(auto) operator()(Array&& array, Number i) const {
    return array[static_cast<std::size_t>(i)];
  }
};

}  // namespace detail

/// nth(array, i) is array[i] of a std::array, std::vector, std::span or C array, i >= 0 of any integer type,
/// and checks no more. An object, so that argument-dependent lookup finds no function of the same name.
inline constexpr detail::nth_element nth;

}  // namespace passive_haptics
