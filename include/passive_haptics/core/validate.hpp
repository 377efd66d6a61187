/// @file
/// How parameters are checked: the checks that a control cycle still asks for.
#pragma once

#include <passive_haptics/core/parameters.hpp>

namespace passive_haptics {
namespace detail {

template <class T>
std::string check_not_negative(const char* name, T value) {
  return range::not_negative.contains(value) ? "" : error_text(name, value, "a finite number >= 0");
}

}  // namespace detail
}  // namespace passive_haptics
