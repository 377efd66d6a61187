/// Error texts for invalid arguments.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace passive_haptics {

// Without exceptions and an operating system, no one could read a text, and it would pull in a heap.
#if defined(__cpp_exceptions) || defined(__unix__) || defined(__APPLE__) || defined(_WIN32) || \
    defined(__EMSCRIPTEN__)
inline constexpr bool errors_have_text = true;  ///< True if error_message is std::string.
#else
inline constexpr bool errors_have_text = false;  ///< True if error_message is std::string.
#endif

/// An error without heap memory. Stores only the name of the invalid member, for a debugger.
class textless_error {
 public:
  textless_error() = default;
  textless_error(const char* name) : name_(name) {}  ///< Stores a string literal.
  /// Stores only whether the text is empty.
  textless_error(const std::string& text) : name_(text.empty() ? "" : "a parameter") {}
  bool empty() const { return *name_ == '\0'; }   ///< True if there is no error.
  operator std::string() const { return name_; }  ///< The stored name.

 private:
  const char* name_ = "";
};

/// Error text, empty if there is none: std::string, or textless_error on microcontrollers.
using error_message = std::conditional_t<errors_have_text, std::string, textless_error>;

namespace detail {

/// The error with the text that the function returns, or only the name if errors have no text.
template <class Name, class Text>
error_message error_of(const Name& name, const Text& text) {
  if constexpr (errors_have_text) return text();
  else return name;
}

}  // namespace detail

/// Throws std::invalid_argument unless the error is empty. Under -fno-exceptions prints the error and aborts,
/// or traps on a microcontroller. For constructors, not for a control cycle.
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
