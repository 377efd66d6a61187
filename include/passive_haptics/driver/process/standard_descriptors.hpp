/// @file
/// Standard input, output and error output of a process that was started without them.
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <initializer_list>

namespace passive_haptics {

/// Opens /dev/null in place of each of the descriptors 0, 1 and 2 that is closed, as under some service
/// managers and after `>&-`. Without this call the next file, socket or serial line of the program gets the
/// free number, and what the program prints goes to the device.
///
/// The place of the call is the first line of main(), before any file, thread or process. The function
/// allocates nothing and is async-signal-safe; a descriptor that is open stays as it is. False, with errno,
/// where a descriptor is still closed, as without a file /dev/null: the program must end then.
inline bool open_standard_descriptors() noexcept {
  for (const int number : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(number, F_GETFD) >= 0) continue;
    if (errno != EBADF) return false;
    // The lowest free number, as those below are open; kept open by exec(), as standard descriptors are
    const int opened = open("/dev/null", O_RDWR);
    if (opened == number) continue;
    if (opened < 0) return false;
    close(opened);  // another thread was quicker; of this no error matters
    errno = EBADF;
    return false;
  }
  return true;
}

namespace detail {

// The file in `descriptor`, from number 3 on: the numbers 0 to 2 are free in a program that was started
// without them, and what it prints must not go there. -1, with errno, where there is none.
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
