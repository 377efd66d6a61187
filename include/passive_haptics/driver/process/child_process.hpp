/// A child process that outlives the loop.
#pragma once

#include <passive_haptics/driver/clock.hpp>
#include <passive_haptics/driver/process/close_files.hpp>
#include <passive_haptics/driver/process/failed_call.hpp>
#include <passive_haptics/driver/process/parent_link.hpp>
#include <passive_haptics/driver/process/standard_descriptors.hpp>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <exception>
#include <string>

namespace passive_haptics {

/// A forked process. Start it before the loop's real-time set-up and before any thread. It ends after its
/// parent, leaves the terminal's process group, and ignores all signals except SIGKILL, SIGSTOP, SIGCONT,
/// SIGCHLD and those of program errors, so that writing to a pipe without a reader, or beyond the file size
/// limit, fails instead of ending it. It keeps only the standard files open. Its parent never waits for it
/// indefinitely.
class child_process {
 public:
  child_process() = default;
  child_process(const child_process&) = delete;
  child_process& operator=(const child_process&) = delete;
  ~child_process() { stop(); }

  /// Forks. In the child, prepare() returns an error, which start() returns in the parent, or an empty
  /// string; then the child executes run(parent_link) and ends. A child that is not ready within `patience`
  /// [s] is ended.
  template <class Prepare, class Run>
  std::string start(Prepare&& prepare, Run&& run, double patience = 10) {
    if (pid_ > 0) return "start() was called twice: the process is running; call it once";
    std::array<int, 2> down{-1, -1}, up{-1, -1};
    std::string error = open_pipe(down);
    if (error.empty()) error = open_pipe(up);
    const pid_t parent = getpid();
    if (error.empty() && (pid_ = fork()) < 0)
      error = detail::failed_call("fork", "end processes, or raise `ulimit -u`");
    if (!error.empty()) {
      for (const int end : {down[0], down[1], up[0], up[1]})
        if (end >= 0) close(end);
      return error;
    }
    if (pid_ == 0) be_child(down[0], up[1], parent, prepare, run);
    close(down[0]);
    close(up[1]);
    pipe_ = down[1];
    error = answer(up[0], patience);
    close(up[0]);
    if (!error.empty()) stop(0);
    return error;
  }

  /// Ends the child: signals it, wakes it whenever it is stopped, waits at most `patience` [s], then kills it
  /// and waits at most one more second. Returns false if it was killed or its function threw.
  bool stop(double patience = default_patience) noexcept {
    if (pid_ <= 0) return true;
    close(pipe_);
    int status = 0;
    bool ended = ends_within(patience, status);
    if (!ended) {
      kill(pid_, SIGKILL);             // fails only if it has ended
      ended = ends_within(1, status);  // a disk may delay even that
    }
    pid_ = -1;
    return ended && WIFEXITED(status) && WEXITSTATUS(status) == 0;
  }

  pid_t pid() const noexcept { return pid_; }  ///< Process number; <= 0 if it does not run.

 private:
  static constexpr char ready = '\n';
  static constexpr double default_patience = 10;  // [s]

  // status is -1 if it was collected elsewhere. Errors of kill() and poll() do not matter: either the child
  // has ended, or the wait is limited to `seconds`.
  bool ends_within(double seconds, int& status) const noexcept {
    for (const double end = monotonic_seconds() + seconds;;) {
      const pid_t ended = waitpid(pid_, &status, WNOHANG);  // not interrupted by signals
      if (ended < 0) status = -1;
      if (ended > 0 || (ended < 0 && errno == ECHILD)) return true;
      if (monotonic_seconds() >= end) return false;
      kill(pid_, SIGCONT);  // it may be stopped at any time
      poll(nullptr, 0, 1);
    }
  }

  // Returns an error or an empty string. The ends are 3 or more even if descriptors 0 to 2 were closed, so
  // that the program's output cannot end the child.
  static std::string open_pipe(std::array<int, 2>& ends) {
    constexpr const char* help = "close files, or raise `ulimit -n`";
    if (pipe2(ends.data(), O_CLOEXEC) != 0) return detail::failed_call("pipe2", help);
    for (int& end : ends)
      if ((end = detail::above_standard_descriptors(end)) < 0) return detail::failed_call("fcntl", help);
    return {};
  }

  // Separates the child from its parent; returns an error or an empty string
  static std::string separate(int down, int up) {
    constexpr const char* help = "allow it if system calls are filtered, as in a container";
    // No session of its own: the scheduler shares out time by sessions (autogroup), and let one wait for
    // half a second
    if (setpgid(0, 0) != 0) return detail::failed_call("setpgid", help);
    for (int signal = 1; signal < NSIG; ++signal)
      if (!is_obeyed(signal) && !ignore(signal)) return detail::failed_call("sigaction", help);
    // If the parent died before this call, its closed pipe is detected at the first look
    if (prctl(PR_SET_PDEATHSIG, SIGCONT) != 0) return detail::failed_call("prctl(PR_SET_PDEATHSIG)", help);
    // Otherwise the child's device or file could get a standard number and receive its error output
    if (!open_standard_descriptors())
      return detail::failed_call("/dev/null", "make it, or start the program with descriptors 0 to 2 open");
    // Another child's pipe, held open here, would hide the death of that child's parent
    return detail::close_all_but({down, up});
  }

  static bool is_obeyed(int signal) noexcept {
    constexpr std::array obeyed{SIGKILL, SIGSTOP, SIGCONT, SIGCHLD, SIGABRT, SIGBUS,
                                SIGFPE,  SIGILL,  SIGSEGV, SIGSYS,  SIGTRAP};
    return std::find(obeyed.begin(), obeyed.end(), signal) != obeyed.end();
  }
  // sigaction(2) rejects the signals 32 and 33, which end processes that do not use them
  static bool ignore(int signal) noexcept {
    const std::array<void*, 5> action{
        reinterpret_cast<void*>(SIG_IGN)};  // then flags, restorer and mask: none
    constexpr std::size_t mask_size = 8;    // [bytes]
    return syscall(SYS_rt_sigaction, signal, action.data(), nullptr, mask_size) == 0;
  }

  template <class Prepare, class Run>
  [[noreturn]] static void be_child(int down, int up, pid_t parent, Prepare& prepare, Run& run) noexcept {
    std::string error = attempt([&] { return separate(down, up); });
    if (error.empty()) error = attempt([&] { return prepare(); });
    if (error.empty() && write(up, &ready, 1) != 1) error = "the parent process has ended";
    if (!error.empty()) {
      complain(up, error);
      _exit(1);  // without the parent's atexit handlers
    }
    close(up);
    error = attempt([&] {
      run(parent_link(down, parent));
      return std::string();
    });
    if (!error.empty()) complain(STDERR_FILENO, error.append("\n"));
    _exit(error.empty() ? 0 : 1);
  }
  template <class Function>
  static std::string attempt(Function&& function) noexcept {
#if defined(__cpp_exceptions)
    try {
      return function();
    } catch (const std::exception& e) {
      const std::string text = e.what();
      return text.empty() ? "an exception without a message" : text;
    }
#else
    return function();
#endif
  }
  // Failure cannot be reported
  static void complain(int to, const std::string& error) noexcept {
    if (write(to, error.data(), error.size()) < 0) return;
  }

  // The child's error; empty if it is ready
  static std::string answer(int from, double patience) {
    std::string text;
    std::array<char, 256> part;
    constexpr double max_wait = 1e6;  // [s], its milliseconds fit in an int
    for (const double end = monotonic_seconds() + patience;;) {
      pollfd watched{from, POLLIN, 0};
      const double left = end - monotonic_seconds();
      const int came = left > 0 ? poll(&watched, 1, static_cast<int>(1e3 * std::min(left, max_wait)) + 1) : 0;
      if (came == 0)
        return "the process was not ready in time; check whether it was stopped, then start the program "
               "again";
      const ssize_t size = came < 0 ? -1 : ::read(from, part.data(), part.size());
      if (size < 0 && errno == EINTR) continue;
      if (size < 0) return detail::failed_call(came < 0 ? "poll" : "read", "start the program again");
      if (size == 0) break;
      text.append(part.data(), static_cast<std::size_t>(size));
    }
    if (text == std::string(1, ready)) return {};
    return text.empty() ? "the process ended before it was ready" : text;
  }

  pid_t pid_ = -1;
  int pipe_ = -1;  // its other end is in the child, which detects its closing
};

}  // namespace passive_haptics
