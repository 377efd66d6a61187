// A process beside the loop where the kernel refuses a system call, as in old containers.
#include "processes.hpp"
#include "system_call_filter.hpp"

#include <gtest/gtest.h>
#include <passive_haptics/driver/process/child_process.hpp>

#include <fcntl.h>
#include <sys/resource.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <functional>
#include <string>
#include <vector>

namespace ph = passive_haptics;

namespace {

struct refusal {
  unsigned call;
  int error;
};

struct refused_calls : ::testing::Test {
  void SetUp() override {
    if (refused({{SYS_acct, EPERM}}, [] { return std::string(); }) != "")
      GTEST_SKIP() << "the kernel has no seccomp filters";
  }

  // What a function returns without these calls.
  static std::string refused(const std::vector<refusal>& all, const std::function<std::string()>& function) {
    return processes::said_by_a_process([&] {
      for (const auto& [call, error] : all)
        if (!system_calls::refuse(call, error)) return std::string("no filters");
      return function();
    });
  }

  static std::string ready() { return {}; }
  static void until_parent_is_gone(ph::parent_link parent) {
    while (!parent.gone_within(1)) {
    }
  }
  static std::string start() {
    ph::child_process child;
    return child.start(ready, until_parent_is_gone);
  }

  // The files that a child has open, without the standard ones.
  static std::string start_and_count_files() {
    std::array<int, 6> files{};
    for (int& file : files) file = dup(STDERR_FILENO);
    const auto count = [&] {
      int open = 0;
      for (int file = STDERR_FILENO + 1; file <= files.back() + 4; ++file) open += fcntl(file, F_GETFD) >= 0;
      return std::to_string(open);
    };
    ph::child_process child;
    return child.start(count, until_parent_is_gone);
  }
};

}  // namespace

TEST_F(refused_calls, without_which_a_child_keeps_no_file_are_replaced) {
  for (const int error : {EPERM, ENOSYS}) {
    const refusal close_range{SYS_close_range, error}, no_proc{SYS_openat, ENOENT};
    EXPECT_EQ(refused({close_range}, start_and_count_files), "2");
    EXPECT_EQ(refused({close_range, no_proc}, start_and_count_files), "2") << "without /proc";
  }
}

TEST_F(refused_calls, that_cannot_be_replaced_are_named) {
  EXPECT_EQ(refused({{SYS_close_range, ENOSYS}, {SYS_openat, ENOENT}, {SYS_prlimit64, EPERM}}, start),
            "close_range: Function not implemented; allow it where system calls are filtered, mount /proc, "
            "or set `ulimit -n 4096`");
  const std::string help =
      ": Operation not permitted; allow it where system calls are filtered, as in a container";
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
    child.start(ready, [](ph::parent_link) {
      for (;;) pause();
    });
    const pid_t process = child.pid();
    if (!system_calls::refuse(SYS_wait4, EPERM)) return std::string("no filters");
    siginfo_t ended{};
    const bool well = child.stop(0.1);
    waitid(P_PID, static_cast<id_t>(process), &ended, WEXITED | WNOWAIT);
    return std::string(well ? "well" : ended.si_status == SIGKILL ? "killed" : "not killed");
  };
  EXPECT_EQ(processes::said_by_a_process(stop), "killed");
}
