// What the loop may ask of the guest's kernel.
#pragma once

#include "../driver/system_call_filter.hpp"

namespace guest {

// From now on ioctl (a port's transfers), clock_nanosleep, clock_gettime (where the kernel cannot answer it
// without a call) and the end of the process; any other call ends it with SIGSYS.
inline bool allow_only_sleep_and_ioctl() {
  return system_calls::allow_only(
      std::array<unsigned, 4>{SYS_ioctl, SYS_clock_nanosleep, SYS_clock_gettime, SYS_exit_group});
}

}  // namespace guest
