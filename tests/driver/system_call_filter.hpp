// Lets a process make a few system calls only, or all but one.
#pragma once

#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>

#include <array>
#include <cstddef>

namespace system_calls {

// False where the kernel has no filters.
template <std::size_t N>
bool install(std::array<sock_filter, N> program) {
  sock_fprog filter{static_cast<unsigned short>(N), program.data()};
  return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
         prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter) == 0;
}

// From now on these; any other call ends the process with SIGSYS. False where the kernel has no filters.
template <std::size_t N>
bool allow_only(const std::array<unsigned, N>& allowed) {
  constexpr auto count = static_cast<unsigned char>(N);
  std::array<sock_filter, N + 3> program{};
  program[0] = BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr));
  for (unsigned char i = 0; i < count; ++i)  // to the last line, past the one before it
    program[1u + i] =
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, allowed[i], static_cast<unsigned char>(count - i), 0);
  program[count + 1u] = BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS);
  program[count + 2u] = BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW);
  return install(program);
}

// From now on this call fails with this error, also in programs that the process starts. False where the
// kernel has no filters.
inline bool refuse(unsigned call, int error) {
  return install(std::array<sock_filter, 4>{
      sock_filter BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
      sock_filter BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, call, 0, 1),
      sock_filter BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | static_cast<unsigned>(error)),
      sock_filter BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW)});
}

}  // namespace system_calls
