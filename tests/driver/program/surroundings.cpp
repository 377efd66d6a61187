// What a service manager or a container takes from the driver: standard descriptors, a system call.
#include "../system_call_filter.hpp"
#include "program.hpp"

#include <cerrno>

namespace surroundings_tests {

using namespace program;

struct a_driver_without : a_driver {
  // A program whose descriptors of these numbers are closed, where the others are /dev/null, and whose
  // close_range fails with this error.
  pid_t spawn_without(const std::vector<int>& closed, const words& command, int error = 0) const {
    const pid_t child = fork();
    if (child != 0) return child;
    for (const int number : {0, 1, 2}) dup2(open("/dev/null", O_RDWR | O_CLOEXEC), number);
    for (const int number : closed) close(number);
    if (error != 0 && !system_calls::refuse(SYS_close_range, error)) _exit(126);
    become(command, directory);
  }
  static std::string file_of(pid_t process, int number) {
    std::error_code gone;
    return fs::read_symlink("/proc/" + std::to_string(process) + "/fd/" + std::to_string(number), gone)
        .string();
  }
  static void expect_null_of(pid_t process) {
    for (const int number : {0, 1, 2}) EXPECT_EQ(file_of(process, number), "/dev/null") << number;
  }
};

TEST_F(a_driver_without, standard_descriptors_leaves_a_whole_log) {
  file("c.toml", settings{}.text());
  for (const std::vector<int>& closed : {std::vector{0}, {1}, {2}, {0, 1, 2}}) {
    pid = spawn_without(closed, {driver, "--config", "c.toml"});
    ASSERT_TRUE(reaches("active")) << ended();
    expect_null_of(pid);
    expect_null_of(recorder());
    expect_null_of(supervisor());
    EXPECT_EQ(interrupt().status, 0);
    expect_whole_log();
    fs::remove(log_path());
  }
}

TEST_F(a_driver_without, close_range_leaves_no_process_where_it_is_killed) {
  file("c.toml", settings{}.text());
  for (const int error : {EPERM, ENOSYS}) {
    pid = spawn_without({}, {driver, "--config", "c.toml"}, error);
    ASSERT_TRUE(reaches("active")) << ended();
    send(SIGKILL);
    EXPECT_EQ(end().status, 128 + SIGKILL);
    expect_whole_log();  // a .part would block the next start
    fs::remove(log_path());
  }
}

}  // namespace surroundings_tests
