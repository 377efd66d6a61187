/// @file
/// A process beside the loop that outlives it.
#pragma once

#include <passive_haptics/driver/clock.hpp>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <string>

namespace passive_haptics {

/// What a child knows of its parent.
class parent_link {
 public:
  /// The child's end of the pipe.
  explicit parent_link(int pipe) : pipe_(pipe) {}

  /// Waits up to `milliseconds`; true at once where the parent is dead or called child_process::stop().
  bool gone(int milliseconds) const noexcept {
    pollfd watched{pipe_, POLLIN, 0};
    return poll(&watched, 1, milliseconds) > 0;
  }

 private:
  int pipe_;
};

/// A forked process. Start it before the loop's real-time set-up and before any thread. It leaves the
/// terminal's process group, so that Ctrl-C, Ctrl-Z and Ctrl-\ do not reach it, and ignores what asks to end:
/// it ends after its parent. Where it is stopped, the end of its parent wakes it. It keeps no file open but
/// the standard ones, and neither ends nor stops when it writes to a pipe that nobody reads any more or to a
/// terminal that others have. Its parent never waits for it without end.
class child_process {
 public:
  child_process() = default;
  child_process(const child_process&) = delete;
  child_process& operator=(const child_process&) = delete;
  ~child_process() { stop(); }

  /// Forks. In the child: prepare() returns an error or an empty string, which start() returns in the parent;
  /// if empty, run(parent_link) follows, and the child ends with it. A child that is not ready within
  /// `patience` [s] is ended.
  template <class Prepare, class Run>
  std::string start(Prepare&& prepare, Run&& run, double patience = 10) {
    if (pid_ > 0) return "start() was called before: the process runs";
    std::array<int, 2> down{-1, -1}, up{-1, -1};
    const bool piped = pipe2(down.data(), O_CLOEXEC) == 0 && pipe2(up.data(), O_CLOEXEC) == 0;
    if (piped) pid_ = fork();
    if (pid_ < 0) {
      const std::string error =
          std::string(piped ? "fork" : "pipe2").append(": ").append(std::strerror(errno));
      for (const int end : {down[0], down[1], up[0], up[1]})
        if (end >= 0) close(end);
      return error;
    }
    if (pid_ == 0) {
      // No session of its own: the scheduler shares out time by sessions (autogroup), and let one wait for
      // half a second
      setpgid(0, 0);
      for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGTTOU}) std::signal(signal, SIG_IGN);
      prctl(PR_SET_PDEATHSIG, SIGCONT);
      close_all_but(down[0], up[1]);
      be_child(up[1], parent_link(down[0]), prepare, run);
    }
    close(down[0]);
    close(up[1]);
    pipe_ = down[1];
    const std::string error = answer(up[0], patience);
    close(up[0]);
    if (!error.empty()) stop(0);
    return error;
  }

  /// Tells the child to end, wakes it whenever it is stopped, and waits for it, at most `patience` [s]; then
  /// it is killed, for which a second more may pass. False if it did not end well: it was killed, or its
  /// function threw.
  bool stop(double patience = default_patience) noexcept {
    if (pid_ <= 0) return true;
    close(pipe_);
    int status = 0;
    bool ended = ends_within(patience, status);
    if (!ended) {
      kill(pid_, SIGKILL);
      ended = ends_within(1, status);  // a disk may hold up even that
    }
    pid_ = -1;
    return ended && WIFEXITED(status) && WEXITSTATUS(status) == 0;
  }

  /// Its process number; <= 0 if it does not run.
  pid_t pid() const noexcept { return pid_; }

 private:
  static constexpr char ready = '\n';
  static constexpr double default_patience = 10;  // [s]

  // Its status is -1 where another took it
  bool ends_within(double seconds, int& status) const noexcept {
    for (const double end = monotonic_seconds() + seconds;;) {
      const pid_t ended = waitpid(pid_, &status, WNOHANG);  // which no signal interrupts
      if (ended < 0) status = -1;
      if (ended != 0) return true;
      if (monotonic_seconds() >= end) return false;
      kill(pid_, SIGCONT);  // it may be stopped at any time
      poll(nullptr, 0, 1);
    }
  }

  // Another child's pipe, held open here, would keep that one from seeing its parent die
  static void close_all_but(int a, int b) noexcept {
    const auto [low, high] = std::minmax({static_cast<unsigned>(a), static_cast<unsigned>(b)});
    if (low > 3) close_range(3, low - 1, 0);
    close_range(low + 1, high - 1, 0);  // refused where they are neighbours
    close_range(high + 1, ~0U, 0);
  }

  template <class Prepare, class Run>
  [[noreturn]] static void be_child(int up, parent_link parent, Prepare& prepare, Run& run) noexcept {
    std::string error = attempt([&] { return prepare(); });
    if (error.empty()) {
      const bool told = write(up, &ready, 1) == 1;
      close(up);
      if (told)
        error = attempt([&] {
          run(parent);
          return std::string();
        });
      if (!error.empty()) complain(STDERR_FILENO, error.append("\n"));
    } else {
      complain(up, error);
    }
    _exit(error.empty() ? 0 : 1);  // not what the parent registered with atexit
  }
  template <class Function>
  static std::string attempt(Function&& function) noexcept {
#if defined(__cpp_exceptions)
    try {
      return function();
    } catch (const std::exception& e) {
      return e.what();
    }
#else
    return function();
#endif
  }
  static void complain(int to, const std::string& error) noexcept {
    if (write(to, error.data(), error.size()) < 0) return;
  }

  // The child's error; empty if it is ready
  static std::string answer(int from, double patience) {
    std::string text;
    std::array<char, 256> part;
    for (const double end = monotonic_seconds() + patience;;) {
      pollfd watched{from, POLLIN, 0};
      const double left = end - monotonic_seconds();
      const int came = left > 0 ? poll(&watched, 1, static_cast<int>(1e3 * left) + 1) : 0;
      if (came == 0) return "the process was not ready in time: was it stopped?";
      const ssize_t size = came < 0 ? -1 : ::read(from, part.data(), part.size());
      if (size < 0 && errno == EINTR) continue;
      if (size <= 0) break;
      text.append(part.data(), static_cast<std::size_t>(size));
    }
    if (text == std::string(1, ready)) return {};
    return text.empty() ? "the process ended before it was ready" : text;
  }

  pid_t pid_ = -1;
  int pipe_ = -1;  // its other end is in the child, which sees it close
};

}  // namespace passive_haptics
