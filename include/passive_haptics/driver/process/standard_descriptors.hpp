/// Standard descriptors of a process that was started without them.
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <initializer_list>

namespace passive_haptics {

/// Opens /dev/null for each closed descriptor 0, 1 and 2; otherwise the next file, socket or serial line
/// would get the free number and the program's output. Call it first in main(). Does not allocate;
/// async-signal-safe. Returns false, with errno, if a descriptor is still closed: the program must then end.
inline bool open_standard_descriptors() noexcept {
  for (const int number : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(number, F_GETFD) >= 0) continue;
    if (errno != EBADF) return false;
    // The lowest free number; kept open by exec()
    const int opened = open("/dev/null", O_RDWR);
    if (opened == number) continue;
    if (opened < 0) return false;
    close(opened);  // another thread was faster
    errno = EBADF;
    return false;
  }
  return true;
}

namespace detail {

// Moves a descriptor to number 3 or more; 0 to 2 may be free. -1, with errno, on failure.
inline int above_standard_descriptors(int descriptor) noexcept {
  if (descriptor < 0 || descriptor > STDERR_FILENO) return descriptor;
  const int moved = fcntl(descriptor, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  const int error = errno;
  close(descriptor);
  errno = error;
  return moved;
}

}  // namespace detail
}  // namespace passive_haptics
