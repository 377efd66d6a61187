// together
// A program that is started without standard input, output or error output.
#include "processes.hpp"
#include "system_call_filter.hpp"

#include <gtest/gtest.h>
#include <passive_haptics/driver/process/standard_descriptors.hpp>

#include <fcntl.h>
#include <sys/stat.h>

#include <cerrno>
#include <string>
#include <vector>

namespace ph = passive_haptics;

namespace standard_descriptors_tests {

// Of each number from 0 to 3: n for /dev/null, c for closed, o for another file.
std::string kinds() {
  struct stat null{}, file{};
  if (stat("/dev/null", &null) != 0) return "no /dev/null";
  std::string all;
  for (int number = 0; number <= 3; ++number)
    all += fstat(number, &file) != 0                               ? 'c'
           : S_ISCHR(file.st_mode) && file.st_rdev == null.st_rdev ? 'n'
                                                                   : 'o';
  return all;
}

// The kinds after the call, where the first numbers were pipes and these are closed.
std::string opened(const std::vector<int>& closed) {
  return processes::said_by_a_process([&]() -> std::string {
    int ends[2];
    if (pipe(ends) != 0) return "no pipe";
    for (const int number : {0, 1, 2, 3}) dup2(ends[0], number);
    for (const int number : closed) close(number);
    return ph::open_standard_descriptors() ? kinds() : "false";
  });
}

TEST(standard_descriptors, that_are_closed_lead_to_dev_null) {
  EXPECT_EQ(opened({0}), "nooo");
  EXPECT_EQ(opened({1}), "onoo");
  EXPECT_EQ(opened({2, 3}), "oonc") << "no more than these";
  EXPECT_EQ(opened({0, 2}), "nono");
  EXPECT_EQ(opened({0, 1, 2}), "nnno");
}

TEST(standard_descriptors, that_are_open_stay) { EXPECT_EQ(opened({}), "oooo"); }

TEST(standard_descriptors, that_cannot_be_opened_are_reported) {
  const auto without_dev_null = [](bool closed) {
    return processes::said_by_a_process([=]() -> std::string {
      if (!system_calls::refuse(SYS_openat, ENOENT)) return "no filters";
      if (closed) close(1);
      if (ph::open_standard_descriptors()) return "open";
      return errno == ENOENT ? "ENOENT" : "another error";
    });
  };
  const std::string open = without_dev_null(false);
  if (open == "no filters") GTEST_SKIP() << "the kernel has no seccomp filters";
  EXPECT_EQ(open, "open") << "nothing is to be opened";
  EXPECT_EQ(without_dev_null(true), "ENOENT");
}

}  // namespace standard_descriptors_tests
