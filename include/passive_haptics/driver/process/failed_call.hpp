/// @file
/// The text of a system call that failed.
#pragma once

#include <cerrno>
#include <cstring>
#include <string>

namespace passive_haptics::detail {

// "fork: Resource temporarily unavailable; ", then what helps: of errno, so right after the call
inline std::string failed_call(const char* call, const char* help) {
  return std::string(call).append(": ").append(std::strerror(errno)).append("; ").append(help);
}

}  // namespace passive_haptics::detail
