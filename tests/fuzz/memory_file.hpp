// A file for programs that read files by name.
#pragma once

#include "input.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <string>
#include <string_view>

namespace fuzz {

// In memory, of these bytes.
class memory_file {
 public:
  explicit memory_file(std::string_view bytes) : fd_(memfd_create("fuzz", MFD_CLOEXEC)) {
    require(write(fd_, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size()),
            "no memory for a file");
  }
  memory_file(const memory_file&) = delete;
  memory_file& operator=(const memory_file&) = delete;
  ~memory_file() { close(fd_); }

  std::string path() const { return "/proc/self/fd/" + std::to_string(fd_); }

 private:
  int fd_;
};

}  // namespace fuzz
