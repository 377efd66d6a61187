// Processes that a test starts and waits for: never without end.
#pragma once

#include "eventually.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

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

// In a forked process: signals do what they do by default, also where the test ignores them, as under nohup.
inline void obey_signals() {
  for (const int signal : {SIGINT, SIGQUIT, SIGHUP, SIGTERM}) std::signal(signal, SIG_DFL);
}

}  // namespace processes
