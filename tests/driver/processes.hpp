// Processes that a test starts and waits for: never without end.
#pragma once

#include <passive_haptics/driver/clock.hpp>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

namespace processes {

// Waits for something that happens; the time is only there to end a test that fails.
template <class What>
bool happens(What&& what) {
  for (const double end = passive_haptics::monotonic_seconds() + 20;
       passive_haptics::monotonic_seconds() < end;) {
    if (what()) return true;
    usleep(1000);
  }
  return what();
}

// What waitpid() tells once it ended; kills it, and the test fails, where it does not end.
inline int end_of(pid_t process) {
  int status = 0;
  if (happens([&] { return waitpid(process, &status, WNOHANG) != 0; })) return status;
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
