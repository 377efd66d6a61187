/// @file
/// The link of a child process to its parent.
#pragma once

#include <poll.h>

#include <cerrno>

namespace passive_haptics {

/// The child's end of a pipe whose other end is the parent's alone: the kernel closes it when the parent
/// dies.
class parent_link {
 public:
  /// The child's end of the pipe.
  explicit parent_link(int pipe) : pipe_(pipe) {}

  /// Waits up to `milliseconds`, less where a signal comes; true at once where the parent is dead or called
  /// child_process::stop(), and where poll(2) fails: a child that cannot see its parent must not wait for it.
  bool gone(int milliseconds) const noexcept {
    pollfd watched{pipe_, POLLIN, 0};
    const int seen = poll(&watched, 1, milliseconds);
    return seen > 0 || (seen < 0 && errno != EINTR);
  }

 private:
  int pipe_;
};

}  // namespace passive_haptics
