/// @file
/// A text as one word of a shell.
#pragma once

#include <string>

namespace example {

/// The text in single quotes: a POSIX shell takes it as it is, whatever stands in it.
inline std::string in_shell_quotes(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'') quoted += "'\\''";
    else quoted += c;
  }
  return quoted + "'";
}

}  // namespace example
