/// An open file or socket with an owner.
#pragma once

#include <poll.h>
#include <unistd.h>

#include <utility>

namespace example {

/// Owns a descriptor; -1 for none.
class file_descriptor {
 public:
  explicit file_descriptor(int fd = -1) noexcept : fd_(fd) {}
  file_descriptor(file_descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  file_descriptor& operator=(file_descriptor&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
  }
  ~file_descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }

  int get() const noexcept { return fd_; }
  bool is_open() const noexcept { return fd_ >= 0; }
  void close() noexcept { file_descriptor().swap(*this); }
  /// Waits until it can be read, at most `timeout` [s].
  void wait(double timeout) const noexcept {
    pollfd p{fd_, POLLIN, 0};
    poll(&p, 1, static_cast<int>(1e3 * timeout) + 1);
  }

 private:
  void swap(file_descriptor& other) noexcept { std::swap(fd_, other.fd_); }

  int fd_;
};

}  // namespace example
