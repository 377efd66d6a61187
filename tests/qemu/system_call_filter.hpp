// Lets a process make a few system calls only.
#pragma once

#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>

#include <array>
#include <cstddef>

namespace guest {

// From now on ioctl (a port's transfers), clock_nanosleep, clock_gettime (where the kernel cannot answer it without a call)
// and the end of the process; any other call ends it with SIGSYS.
inline bool allow_only_sleep_and_ioctl() {
  constexpr std::array<unsigned, 4> allowed{SYS_ioctl, SYS_clock_nanosleep, SYS_clock_gettime,
                                            SYS_exit_group};
  constexpr auto count = static_cast<unsigned char>(allowed.size());
  std::array<sock_filter, allowed.size() + 3> program{};
  program[0] = BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr));
  for (unsigned char i = 0; i < count; ++i)  // to the last line, past the one before it
    program[1u + i] =
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, allowed[i], static_cast<unsigned char>(count - i), 0);
  program[count + 1u] = BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS);
  program[count + 2u] = BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW);
  sock_fprog filter{static_cast<unsigned short>(program.size()), program.data()};
  return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
         prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter) == 0;
}

}  // namespace guest
