/// @file
/// The link of a child process to its parent.
#pragma once

#include <poll.h>
#include <unistd.h>

#include <cerrno>

namespace passive_haptics {

/// The child's end of a pipe: the kernel closes the other end when the parent dies. If a process that the
/// parent forked holds that end open, too, the number of the child's own parent says that it died.
class parent_link {
 public:
  /// The child's end of the pipe, and the parent's process number.
  parent_link(int pipe, pid_t parent) : pipe_(pipe), parent_(parent) {}

  /// Waits up to `milliseconds`, less where a signal comes; true where the parent is dead or called
  /// child_process::stop(), at once where the pipe is closed, and where poll(2) fails: a child that cannot
  /// see its parent must not wait for it.
  bool gone(int milliseconds) const noexcept {
    pollfd watched{pipe_, POLLIN, 0};
    const int seen = poll(&watched, 1, milliseconds);
    return seen > 0 || (seen < 0 && errno != EINTR) || getppid() != parent_;
  }

 private:
  int pipe_;
  pid_t parent_;
};

}  // namespace passive_haptics
