// Programs with a deadline, several at a time.
#pragma once

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace mutants {

enum class ending { passed, failed, crashed, late };

inline std::string word_of(ending how) {
  const char* words[] = {"passed", "failed", "crashed", "late"};
  return words[static_cast<int>(how)];
}

struct ended {
  ending how;
  double cpu;  // [s]
};

struct deadline {
  unsigned cpu, clock;  // [s]; the second one is generous, as the machine may be busy
};

using environment = std::vector<std::pair<std::string, std::string>>;

inline std::string read_text(const std::filesystem::path& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

// Leaves a file alone that says so already: then nothing is built again.
inline void write_text(const std::filesystem::path& path, const std::string& text) {
  if (std::filesystem::exists(path) && read_text(path) == text) return;
  std::filesystem::create_directories(path.parent_path());
  std::ofstream(path) << text;
}

inline ended run(const std::vector<std::string>& command, const std::filesystem::path& output,
                 const environment& variables = {}, deadline limit = {3600, 7200}) {
  std::vector<char*> arguments;
  for (const std::string& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
  const pid_t child = ::fork();
  if (child == 0) {
    ::setpgid(0, 0);
    const int out = ::open(output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    ::dup2(out, STDOUT_FILENO);
    ::dup2(out, STDERR_FILENO);
    ::dup2(::open("/dev/null", O_RDONLY), STDIN_FILENO);
    for (const auto& [name, value] : variables) ::setenv(name.c_str(), value.c_str(), 1);
    const rlimit cpu{limit.cpu, limit.cpu + 1}, no_core{0, 0};
    ::setrlimit(RLIMIT_CPU, &cpu);
    ::setrlimit(RLIMIT_CORE, &no_core);
    ::alarm(limit.clock);
    ::execvp(arguments[0], arguments.data());
    ::_exit(127);
  }
  int status = 0;
  rusage used{};
  ::wait4(child, &status, 0, &used);
  ::kill(-child, SIGKILL);  // those that it left behind
  const double cpu = static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
                     1e-6 * static_cast<double>(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return {ending::passed, cpu};
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status) - 128;  // as shells say it
  if (signal == SIGXCPU || signal == SIGALRM || (signal == SIGKILL && cpu >= limit.cpu))
    return {ending::late, cpu};
  return {signal > 0 ? ending::crashed : ending::failed, cpu};
}

// What goes before a command so that it sees no other processes: a mutant may kill all that it sees. Nothing
// where the kernel does not let us.
inline const std::vector<std::string>& apart() {
  static const std::vector<std::string> prefix = [] {
    const std::vector<std::string> own = {"unshare", "--pid", "--fork", "--kill-child"};
    std::vector<std::string> as_user = own;
    as_user.insert(as_user.begin() + 1, {"--user", "--map-current-user"});
    for (const auto& one : {own, as_user}) {
      std::vector<std::string> probe = one;
      probe.push_back("true");
      if (run(probe, "/dev/null").how == ending::passed) return one;
    }
    return std::vector<std::string>();
  }();
  return prefix;
}

// Runs a test, which may be of a mutant.
inline ended run_apart(std::vector<std::string> command, const std::filesystem::path& output,
                       const environment& variables = {}, deadline limit = {3600, 7200}) {
  command.insert(command.begin(), apart().begin(), apart().end());
  return run(command, output, variables, limit);
}

// f(i, worker) for all i below count.
template <class F>
void in_parallel(std::size_t count, unsigned workers, const F& f) {
  std::atomic<std::size_t> next = 0;
  std::vector<std::jthread> threads;
  for (unsigned w = 0; w < workers; ++w) {
    threads.emplace_back([&, w] {
      for (std::size_t i = next++; i < count; i = next++) f(i, w);
    });
  }
}

}  // namespace mutants
