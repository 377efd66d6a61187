// Processes that a test starts and waits for: never without end.
#pragma once

#include "eventually.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <functional>
#include <string>

namespace processes {

// What waitpid() tells once it ended; kills it, and the test fails, where it does not end.
inline int end_of(pid_t process) {
  int status = 0;
  if (eventually([&] { return waitpid(process, &status, WNOHANG) != 0; })) return status;
  ADD_FAILURE() << "process " << process << " does not end";
  kill(process, SIGKILL);
  waitpid(process, &status, 0);
  return status;
}

// What a function returns in a process of its own, with which the limits, closed files and refused system
// calls end.
inline std::string said_by_a_process(const std::function<std::string()>& function) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK) != 0) return "no pipe";
  const pid_t process = fork();
  if (process == 0) {
    const std::string text = function();
    _exit(write(ends[1], text.data(), text.size()) < 0);
  }
  const int status = end_of(process);
  std::array<char, 1000> text{};
  const ssize_t size = read(ends[0], text.data(), text.size());
  for (const int end : ends) close(end);
  if (status != 0) return "status " + std::to_string(status);
  return std::string(text.data(), size > 0 ? static_cast<std::size_t>(size) : 0);
}

// In a forked process: signals do what they do by default, also where the test ignores them, as under nohup.
inline void obey_signals() {
  for (const int signal : {SIGINT, SIGQUIT, SIGHUP, SIGTERM}) std::signal(signal, SIG_DFL);
}

}  // namespace processes
