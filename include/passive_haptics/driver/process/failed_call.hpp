/// Error text of a failed system call.
#pragma once

#include <cerrno>
#include <cstring>
#include <string>

namespace passive_haptics::detail {

// "fork: Resource temporarily unavailable; " and a remedy; uses errno
inline std::string failed_call(const char* call, const char* help) {
  return std::string(call).append(": ").append(std::strerror(errno)).append("; ").append(help);
}

}  // namespace passive_haptics::detail
