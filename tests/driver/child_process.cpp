// together
// A process beside the loop: that it ends after its parent, whatever happens to either.
#include "processes.hpp"
#include "system_call_filter.hpp"

#include <gtest/gtest.h>
#include <passive_haptics/driver/process/child_process.hpp>
#include <passive_haptics/driver/process/shared_memory.hpp>

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/time.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <functional>
#include <new>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace ph = passive_haptics;

namespace child_process_tests {

std::string ready() { return {}; }
void until_parent_is_gone(ph::parent_link parent) {
  while (!parent.gone_within(1)) {
  }
}
void for_ever(ph::parent_link) {
  for (;;) pause();
}

// SIGUSR1 interrupts what waits, and does no more.
struct hears_signals {
  struct sigaction before{};
  hears_signals() {
    struct sigaction heard{};
    heard.sa_handler = [](int) {};
    sigaction(SIGUSR1, &heard, &before);
  }
  ~hears_signals() { sigaction(SIGUSR1, &before, nullptr); }
};

bool is_open(int file) { return fcntl(file, F_GETFD) >= 0; }

// How many files a child has open, among many of its parent.
std::string files_of_a_child() {
  std::array<int, 12> files{};
  for (int& file : files) file = dup(STDERR_FILENO);
  for (const std::size_t gap : {2u, 4u, 5u, 8u}) close(files[gap]);  // where the pipes come
  const auto count = [&] {
    int open = 0;
    for (int file = STDERR_FILENO + 1; file <= files.back(); ++file) open += is_open(file);
    return std::to_string(open);
  };
  ph::child_process child;
  std::string counted = child.start(count, until_parent_is_gone);
  for (const int file : files)
    if (is_open(file)) close(file);
  return counted;
}

// Whether it is stopped, as ps(1) shows it.
bool is_stopped(pid_t process) {
  siginfo_t what{};
  return waitid(P_PID, static_cast<id_t>(process), &what, WSTOPPED | WNOHANG | WNOWAIT) == 0 &&
         what.si_pid == process;
}

// A kernel that refuses system calls, as in old containers.
struct refusal {
  unsigned call;
  int error;
};

struct refused_calls : ::testing::Test {
  void SetUp() override {
    if (refused({{SYS_acct, EPERM}}, [] { return std::string(); }) != "")
      GTEST_SKIP() << "the kernel has no seccomp filters";
  }

  // The result of a function without these calls.
  static std::string refused(const std::vector<refusal>& all, const std::function<std::string()>& function) {
    return processes::said_by_a_process([&] {
      for (const auto& [call, error] : all)
        if (!system_calls::refuse(call, error)) return std::string("no filters");
      return function();
    });
  }
};

TEST(a_child_process, that_is_stopped_is_woken_to_end_well) {
  ph::child_process child;
  ASSERT_EQ(child.start(ready, until_parent_is_gone), "");
  kill(child.pid(), SIGSTOP);
  ASSERT_TRUE(eventually([&] { return is_stopped(child.pid()); }));
  EXPECT_TRUE(child.stop());
}

TEST(a_child_process, that_is_stopped_as_it_ends_is_woken_too) {
  ph::child_process child;
  const auto stops_at_its_end = [](ph::parent_link parent) {
    until_parent_is_gone(parent);
    poll(nullptr, 0, 20);
    raise(SIGSTOP);
  };
  ASSERT_EQ(child.start(ready, stops_at_its_end), "");
  EXPECT_TRUE(child.stop());
}

TEST(a_child_process, that_does_not_end_is_killed) {
  ph::child_process child;
  ASSERT_EQ(child.start(ready, for_ever), "");
  const pid_t process = child.pid();
  EXPECT_FALSE(child.stop(0.1));
  EXPECT_EQ(kill(process, SIGKILL), -1) << "it is still there";
}

// Through a signal of a child that says nothing, and where next to no time is left.
TEST(a_child_process, that_is_not_ready_is_no_child) {
  const hears_signals on;
  const std::string late =
      "the process was not ready in time; check whether it was stopped, then start the program again";
  const auto throws = [](const std::string& text) {
    return [text]() -> std::string { throw std::runtime_error(text); };
  };
  const auto never = [](bool signals) {
    return [signals] {
      if (signals) poll(nullptr, 0, 10), kill(getppid(), SIGUSR1);
      for (;;) pause();
      return std::string();
    };
  };
  const auto ends = [] {
    _exit(0);
    return std::string();
  };
  struct row {
    std::function<std::string()> ready;
    double patience;
    std::string error;
  };
  for (const auto& [ready, patience, error] :
       {row{throws("no device"), 10, "no device"}, row{throws(""), 10, "an exception without a message"},
        row{ends, 10, "the process ended before it was ready"}, row{never(true), 0.1, late},
        row{never(false), 5e-4, late}, row{never(false), 0, late}}) {
    ph::child_process child;
    EXPECT_EQ(child.start(ready, until_parent_is_gone, patience), error);
    EXPECT_LE(child.pid(), 0);
  }
}

TEST(a_child_process, that_gets_no_pipe_leaves_no_file_open) {
  const int next = dup(STDIN_FILENO);
  close(next);
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &before), 0);
  const rlimit room_for_one_pipe{static_cast<rlim_t>(next) + 3, before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &room_for_one_pipe), 0);
  ph::child_process child;
  const std::string error = child.start(ready, for_ever);
  setrlimit(RLIMIT_NOFILE, &before);
  EXPECT_EQ(error, "pipe2: Too many open files; close files, or raise `ulimit -n`");
  const int again = dup(STDIN_FILENO);
  EXPECT_EQ(again, next);
  close(again);
}

TEST(a_child_process, that_another_one_waited_for_is_not_waited_for) {
  ph::child_process child;
  ASSERT_EQ(child.start(ready, for_ever), "");
  kill(child.pid(), SIGKILL);
  ASSERT_GE(waitpid(child.pid(), nullptr, 0), 0);
  EXPECT_FALSE(child.stop());
}

// Whether a child sees its parent die, which did something after the start: `beside` returns a process that
// is killed at the end.
bool sees_its_parent_die(const std::function<pid_t(const ph::child_process&)>& beside) {
  // The child comes to this process, in the same session: else the kernel wakes those without a parent there
  prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0);
  ph::shared_memory<std::atomic<pid_t>> other;
  ph::shared_memory<std::atomic<bool>> ended;
  const pid_t parent = fork();
  if (parent == 0) {
    ph::child_process child;
    child.start(ready, [&](ph::parent_link link) {
      until_parent_is_gone(link);
      *ended = true;
    });
    *other = beside(child);
    for (;;) pause();
  }
  const bool done = eventually([&] { return *other != 0; });
  kill(parent, SIGKILL);
  processes::end_of(parent);
  const bool seen = eventually([&] { return ended->load(); });
  kill(*other, SIGKILL);
  processes::end_of(*other);
  return done && seen;
}

TEST(a_child_process, that_is_stopped_ends_when_its_parent_dies) {
  EXPECT_TRUE(sees_its_parent_die([](const ph::child_process& child) {
    kill(child.pid(), SIGSTOP);
    eventually([&] { return is_stopped(child.pid()); });
    return child.pid();
  }));
}

// Another process that the parent forked, as a user's program may, has the parent's end of the pipe.
TEST(a_child_process, ends_when_its_parent_dies_beside_others_that_it_forked) {
  EXPECT_TRUE(sees_its_parent_die([](const ph::child_process&) {
    const pid_t forked = fork();
    while (forked == 0) pause();
    return forked;
  }));
}

TEST(a_child_process, hears_nothing_that_is_meant_for_its_parent) {
  ph::child_process child;
  EXPECT_TRUE(child.stop()) << "nothing runs yet";
  ASSERT_EQ(child.start(ready, until_parent_is_gone), "");
  EXPECT_EQ(getpgid(child.pid()), child.pid()) << "Ctrl-C, Ctrl-Z and Ctrl-\\ go to a group";
  const std::set<int> obeyed{SIGKILL, SIGSTOP, SIGCONT, SIGCHLD, SIGABRT, SIGBUS,
                             SIGFPE,  SIGILL,  SIGSEGV, SIGSYS,  SIGTRAP};
  for (int signal = 1; signal <= SIGRTMAX; ++signal)
    if (!obeyed.contains(signal)) kill(child.pid(), signal);
  EXPECT_TRUE(child.stop()) << "not ended by a signal";
  EXPECT_TRUE(child.stop()) << "nothing runs any more";
}

TEST(a_child_process, keeps_no_file_open_but_the_standard_ones_and_its_pipes) {
  EXPECT_EQ(files_of_a_child(), "2");
}

TEST(a_child_process, of_a_program_without_standard_descriptors_takes_none_of_them) {
  const auto start = [] {
    for (const int number : {0, 1, 2}) close(number);
    const auto has_its_own = [] {
      return std::string(is_open(0) && is_open(1) && is_open(2) ? "" : "the child has none");
    };
    ph::child_process child;
    std::string wrong = child.start(has_its_own, until_parent_is_gone);
    for (const int number : {0, 1, 2})
      if (is_open(number)) wrong += " taken: " + std::to_string(number);
    return child.stop() ? wrong : wrong + " did not end well";
  };
  EXPECT_EQ(processes::said_by_a_process(start), "");
}

TEST(a_child_process, is_waited_for_on_through_signals) {
  const hears_signals on;
  const auto ready_after_signals = [] {
    for (int k = 0; k < 20; ++k) {
      kill(getppid(), SIGUSR1);
      poll(nullptr, 0, 1);
    }
    return std::string();
  };
  ph::child_process child;
  EXPECT_EQ(child.start(ready_after_signals, until_parent_is_gone), "");
  EXPECT_TRUE(child.stop());
}

// CPU time, which a busy machine does not add to.
TEST(a_child_process, is_waited_for_asleep) {
  const auto used = [] {
    rusage all{};
    getrusage(RUSAGE_SELF, &all);
    return static_cast<double>(all.ru_utime.tv_sec + all.ru_stime.tv_sec) +
           1e-6 * static_cast<double>(all.ru_utime.tv_usec + all.ru_stime.tv_usec);
  };
  ph::child_process child;
  ASSERT_EQ(child.start(ready, [](ph::parent_link) { poll(nullptr, 0, 500); }), "");
  const double before = used();
  EXPECT_TRUE(child.stop());
  EXPECT_LT(used() - before, 0.25);
}

TEST(a_parent_link, that_cannot_be_watched_counts_the_parent_as_gone_but_not_for_a_signal) {
  const auto look = [](bool watched) {
    return processes::said_by_a_process([=] {
      std::array<int, 2> ends{};
      const itimerval soon{{0, 0}, {0, 10'000}};
      const rlimit none{0, 0};  // poll(2) fails
      std::signal(SIGALRM, [](int) {});
      if (pipe(ends.data()) != 0 || setitimer(ITIMER_REAL, &soon, nullptr) != 0 ||
          (!watched && setrlimit(RLIMIT_NOFILE, &none) != 0))
        return std::string("no pipe");
      return std::string(ph::parent_link(ends[0], getppid()).gone_within(watched ? 5 : 0) ? "gone" : "there");
    });
  };
  EXPECT_EQ(look(false), "gone");
  EXPECT_EQ(look(true), "there");
}

TEST(shared_memory, throws_where_there_is_none) {
  struct larger_than_any_machine {
    char bytes[std::size_t{1} << 60];
  };
  EXPECT_THROW(ph::shared_memory<larger_than_any_machine>(), std::bad_alloc);
}

TEST(shared_memory, is_given_back_once_it_is_out_of_use) {
  int* where = nullptr;
  {
    ph::shared_memory<int> first;
    *first = 7;
    const ph::shared_memory<int> last = std::move(first);
    where = &*last;
    EXPECT_EQ(*where, 7);
  }
  EXPECT_EQ(msync(where, sizeof(int), MS_ASYNC), -1) << "it is still mapped";
}

TEST_F(refused_calls, without_which_a_child_keeps_no_file_are_replaced) {
  for (const int error : {EPERM, ENOSYS}) {
    const refusal close_range{SYS_close_range, error}, no_proc{SYS_openat, ENOENT};
    EXPECT_EQ(refused({close_range}, files_of_a_child), "2");
    EXPECT_EQ(refused({close_range, no_proc}, files_of_a_child), "2") << "without /proc";
  }
}

TEST_F(refused_calls, that_cannot_be_replaced_are_named) {
  const auto start = [] { return ph::child_process().start(ready, until_parent_is_gone); };
  EXPECT_EQ(refused({{SYS_close_range, ENOSYS}, {SYS_openat, ENOENT}, {SYS_prlimit64, EPERM}}, start),
            "close_range: Function not implemented; allow it if system calls are filtered, mount /proc, "
            "or set `ulimit -n 4096`");
  const std::string help =
      ": Operation not permitted; allow it if system calls are filtered, as in a container";
  EXPECT_EQ(refused({{SYS_setpgid, EPERM}}, start), "setpgid" + help);
  EXPECT_EQ(refused({{SYS_rt_sigaction, EPERM}}, start), "sigaction" + help);
  EXPECT_EQ(refused({{SYS_prctl, EPERM}}, start), "prctl(PR_SET_PDEATHSIG)" + help);
  EXPECT_EQ(refused({{SYS_clone, EAGAIN}}, start),
            "fork: Resource temporarily unavailable; end processes, or raise `ulimit -u`");
}

TEST_F(refused_calls, are_not_repeated_for_each_of_too_many_files) {
  EXPECT_FALSE(ph::detail::close_up_to(1'000'000'000, {3, 4}));
  EXPECT_FALSE(ph::detail::close_up_to(RLIM_INFINITY, {3, 4}));
}

TEST_F(refused_calls, leave_no_child_that_cannot_be_waited_for) {
  const auto stop = [] {
    ph::child_process child;
    child.start(ready, for_ever);
    const pid_t process = child.pid();
    if (!system_calls::refuse(SYS_wait4, EPERM)) return std::string("no filters");
    siginfo_t ended{};
    const bool well = child.stop(0.1);
    waitid(P_PID, static_cast<id_t>(process), &ended, WEXITED | WNOWAIT);
    return std::string(well ? "well" : ended.si_status == SIGKILL ? "killed" : "not killed");
  };
  EXPECT_EQ(processes::said_by_a_process(stop), "killed");
}

}  // namespace child_process_tests
