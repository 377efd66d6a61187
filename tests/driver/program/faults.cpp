// What is done to the driver's processes while its brakes may hold.
#include "program.hpp"

namespace faults_tests {

using namespace program;

struct a_driver_whose : a_driver {};

// Not that something moved
TEST_F(a_driver_whose, homing_does_not_end_says_why) {
  start(settings{.max_sleep = 0.3, .homing = 30});
  ASSERT_TRUE(eventually([&] { return log().size() > 10; })) << ended();
  freeze(1);
  ASSERT_TRUE(reaches("released"));
  const outcome stopped = interrupt();
  EXPECT_TRUE(has(stopped.out, "homing did not end: the brakes were released first\n")) << stopped.out;

  fs::remove(log_path());
  std::string text = settings{}.text();
  text.replace(text.find("max_gap = 5"), 11, "max_gap = 1e-4");
  const outcome apart = run(text, {"--seconds", "0.5", "--quiet"});
  EXPECT_TRUE(has(apart.out, "homing did not end: samples came more than [homing] max_gap apart"))
      << apart.out;

  fs::remove(log_path());
  const outcome brief = run(settings{.homing = 30}.text(), {"--seconds", "0.2", "--quiet"});
  EXPECT_TRUE(has(brief.out, "homing did not end: the program ended before it was over\n")) << brief.out;
}

// Whoever sends the request cannot know of the release: the loop does not either.
TEST_F(a_driver_whose, rearm_request_waited_in_a_freeze_stays_released) {
  start(settings{.supervisor_timeout = 0.25});
  ASSERT_TRUE(reaches("active")) << ended();
  send(SIGSTOP);
  usleep(1'000'000);
  send(SIGUSR1);
  send(SIGCONT);
  std::size_t row = 0;
  ASSERT_TRUE(reaches("released", 0, &row));
  ASSERT_TRUE(eventually([&] { return log().size() > row + 200; }));
  EXPECT_EQ(interrupt().status, 3);
  const log_file all = log();
  for (std::size_t i = row; i < all.size(); ++i) ASSERT_EQ(all.text(i, "state"), "released");
}

TEST_F(a_driver_whose, supervisor_is_killed_is_released_for_good) {
  start(settings{.supervisor_timeout = 0.3});
  ASSERT_TRUE(reaches("active")) << ended();
  ASSERT_GT(supervisor(), 0);
  send(SIGKILL, supervisor());
  std::size_t row = 0;
  ASSERT_TRUE(reaches("released", 0, &row));
  send(SIGUSR1);
  ASSERT_TRUE(eventually([&] { return log().size() > row + 500; }));
  const outcome o = interrupt();
  EXPECT_EQ(o.status, 3);
  expect_released_at_the_end("the supervisor is lost, or released the brakes");
  const log_file all = log();
  for (std::size_t i = row; i < all.size(); ++i)
    ASSERT_EQ(all.text(i, "state"), "released") << "not rearmed without a supervisor";
}

TEST_F(a_driver_whose, output_nobody_reads_writes_its_log_all_the_same) {
  file("c.toml", settings{}.text());
  std::array<int, 2> ends;
  ASSERT_EQ(pipe2(ends.data(), O_CLOEXEC), 0);
  pid = fork();
  if (pid == 0) {
    dup2(ends[1], STDOUT_FILENO);
    become({driver, "--config", "c.toml"}, directory);
  }
  close(ends[1]);
  ASSERT_TRUE(reaches("active")) << ended();
  close(ends[0]);
  const double closed = time_written();
  EXPECT_TRUE(eventually([&] { return time_written() > closed + 2.2; })) << "past two lines of the report";
  send(SIGINT);
  status_of(pid);
  expect_whole_log();
}

}  // namespace faults_tests
