/// Array access by signed or unsigned indices.
#pragma once

#include <passive_haptics/core/flatten.hpp>

#include <cstddef>

namespace passive_haptics {

namespace detail {

struct nth_element {
  template <class Array, class Number>
  PASSIVE_HAPTICS_INLINE constexpr decltype(auto) operator()(Array&& array, Number i) const {
    return array[static_cast<std::size_t>(i)];
  }
};

}  // namespace detail

/// nth(array, i) returns array[i] of a std::array, std::vector, std::span or C array, for i >= 0 of any
/// integer type, unchecked. It is an object so that argument-dependent lookup finds no other function.
inline constexpr detail::nth_element nth;

}  // namespace passive_haptics
