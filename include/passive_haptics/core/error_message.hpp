/// @file
/// What is wrong with what a user wrote.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace passive_haptics {

// Without exceptions and an operating system nobody could read a text, and it would bring a heap with it
#if defined(__cpp_exceptions) || defined(__unix__) || defined(__APPLE__) || defined(_WIN32) || \
    defined(__EMSCRIPTEN__)
inline constexpr bool errors_have_text = true;  ///< Whether an error_message is a std::string.
#else
inline constexpr bool errors_have_text = false;  ///< Whether an error_message is a std::string.
#endif

/// Whether something is wrong, and for a debugger the name of the wrong member: an error without a heap.
class textless_error {
 public:
  textless_error() = default;
  /// A literal.
  textless_error(const char* name) : name_(name) {}
  /// Of a text only whether there is one.
  textless_error(const std::string& text) : name_(text.empty() ? "" : "a parameter") {}
  /// Nothing is wrong.
  bool empty() const { return *name_ == '\0'; }
  /// The name.
  operator std::string() const { return name_; }

 private:
  const char* name_ = "";
};

/// What is wrong, empty if nothing: a std::string, but where a microcontroller has no exceptions.
using error_message = std::conditional_t<errors_have_text, std::string, textless_error>;

namespace detail {

/// The error whose text this function returns; where errors have no text, the name alone, and no code of the
/// function.
template <class Name, class Text>
error_message error_of(const Name& name, const Text& text) {
  if constexpr (errors_have_text) return text();
  else return name;
}

}  // namespace detail

/// Throws std::invalid_argument with this error unless it is empty; under -fno-exceptions prints it and ends
/// the program, on a microcontroller by a trap. For constructors, never for a control cycle.
inline void require_no_error(const error_message& error) {
  if (error.empty()) return;
#if defined(__cpp_exceptions)
  throw std::invalid_argument("passive_haptics: " + error);
#else
  if constexpr (errors_have_text) {
    std::fprintf(stderr, "passive_haptics: %s\n", std::string(error).c_str());
    std::abort();
  }
  __builtin_trap();
#endif
}

}  // namespace passive_haptics
