/// The link of a child process to its parent.
#pragma once

#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstdint>
#include <ctime>

namespace passive_haptics {

/// The child's end of a pipe: the kernel closes the other end when the parent dies. If another child of the
/// parent keeps that end open, the changed parent process number shows the death.
class parent_link {
 public:
  /// The child's end of the pipe, and the parent's process number.
  parent_link(int pipe, pid_t parent) : pipe_(pipe), parent_(parent) {}

  /// Waits up to `seconds`, less if a signal arrives. Returns true if the parent is dead or called
  /// child_process::stop(), and if ppoll(2) fails.
  bool gone_within(double seconds) const noexcept {
    pollfd watched{pipe_, POLLIN, 0};
    const std::int64_t ns = std::llround(1e9 * seconds);
    const timespec wait{static_cast<time_t>(ns / 1'000'000'000), static_cast<long>(ns % 1'000'000'000)};
    const int seen = ppoll(&watched, 1, &wait, nullptr);
    return seen > 0 || (seen < 0 && errno != EINTR) || getppid() != parent_;
  }

 private:
  int pipe_;
  pid_t parent_;
};

}  // namespace passive_haptics
