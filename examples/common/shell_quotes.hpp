/// Quoting for a shell.
#pragma once

#include <string>

namespace example {

/// The text in single quotes, which a POSIX shell does not interpret.
inline std::string in_shell_quotes(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'') quoted += "'\\''";
    else quoted += c;
  }
  return quoted + "'";
}

}  // namespace example
