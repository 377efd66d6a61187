/// @file
/// How parameters are checked, once, before anything runs.
#pragma once

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace passive_haptics {
namespace detail {

template <class T>
std::string error_text(std::string_view name, T value, std::string_view expected) {
  std::ostringstream text;
  text << name << " = " << value << ", expected " << expected;
  return text.str();
}

/// "before i after". (A literal + std::string makes g++ 12 warn of overlapping memory at -O3.)
template <class Index>
std::string indexed(std::string_view before, Index i, std::string_view after) {
  std::ostringstream text;
  text << before << i << after;
  return text.str();
}

template <class T>
std::string check_positive(std::string_view name, T value) {
  return std::isfinite(value) && value > T(0) ? "" : error_text(name, value, "a finite number > 0");
}

template <class T>
std::string check_not_negative(std::string_view name, T value) {
  return std::isfinite(value) && value >= T(0) ? "" : error_text(name, value, "a finite number >= 0");
}

template <class T>
std::string check_finite(std::string_view name, T value) {
  return std::isfinite(value) ? "" : error_text(name, value, "a finite number");
}

/// Checks each element of a vector, as name[i] [unit]; says what is wrong with the first that is.
template <class Vector>
std::string check_each_not_negative(std::string_view name, std::string_view unit, const Vector& values) {
  std::string text;
  for (int i = 0; i < static_cast<int>(values.size()) && text.empty(); ++i) {
    const std::string after = std::string("] [").append(unit).append("]");
    text = check_not_negative(indexed(std::string(name).append("["), i, after), values[i]);
  }
  return text;
}

/// The first error that is not empty.
template <class... Strings>
std::string first_error(Strings... errors) {
  std::string first;
  ((first.empty() ? void(first = std::move(errors)) : void()), ...);
  return first;
}

}  // namespace detail

/// Throws std::invalid_argument with this error unless it is empty. Under -fno-exceptions it prints the error
/// and ends the program. For constructors, never for a control cycle.
inline void require_no_error(const std::string& error) {
  if (error.empty()) return;
#if defined(__cpp_exceptions)
  throw std::invalid_argument("passive_haptics: " + error);
#else
  std::fprintf(stderr, "passive_haptics: %s\n", error.c_str());
  std::abort();
#endif
}

/// The parameters themselves, if validate(parameters) has no error; else see require_no_error().
template <class Parameters>
const Parameters& require_valid(const Parameters& parameters) {
  require_no_error(validate(parameters));
  return parameters;
}

}  // namespace passive_haptics
