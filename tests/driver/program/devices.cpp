// The driver with a board on a pseudo-terminal and a force sensor on the loopback interface.
#include "net_ft_peer.hpp"
#include "program.hpp"

namespace {

using namespace program;

struct a_board : a_driver_at_a_terminal {
  pid_t board = -1;

  // Its watchdog has time, as this machine may have none, and the 1000 samples that may be missing last for 4
  // s: of a pseudo-terminal the kernel may make the port's thread wait.
  void plug_in() {
    board = spawn({firmware, "--link", "brakes", "--watchdog", "20000", "--period", "10000"}, "firmware");
    ASSERT_TRUE(eventually([this] { return fs::is_symlink(directory / "brakes"); }));
  }
  void drive(const settings& s) {
    plug_in();
    start(s);
    ASSERT_TRUE(reaches("active")) << ended();
  }
  static settings connected(double hold_over = 5) {
    return {.hold_over = hold_over,
            .top = "law = \"no_direct_control\"",
            .sections = "[port]\ntype = \"serial\"\ndevice = \"brakes\"\nopen_timeout = 20\n",
            .sensor = "type = \"none\""};
  }
};

TEST_F(a_board, is_driven) {
  ASSERT_NO_FATAL_FAILURE(drive(connected()));
  ASSERT_TRUE(eventually([this] { return time_written() > 1.5; }));
  const outcome o = interrupt();
  EXPECT_EQ(o.status, 0) << o.out << o.err;
  EXPECT_TRUE(log().is_whole());
  double least = 1e9, most = -1e9;
  const log_file all = log();
  for (std::size_t i = 0; i < all.size(); i += 100) {
    least = std::min(least, all.number(i, "q1"));
    most = std::max(most, all.number(i, "q1"));
  }
  EXPECT_GT(most, least) << "the board's hand moves";
}

TEST_F(a_board, that_is_gone_releases_at_once) {
  ASSERT_NO_FATAL_FAILURE(drive(connected()));
  send(SIGKILL, board);
  ASSERT_TRUE(reaches("released")) << ended();
  const outcome o = interrupt();
  EXPECT_EQ(o.status, 3);
  EXPECT_TRUE(has(o.out, "device lost")) << o.out;
  EXPECT_TRUE(has(o.out, "start again, at the home pose")) << o.out;
  EXPECT_TRUE(has(log().text(log().size() - 1, "reason"), "device lost"));
  EXPECT_TRUE(nothing_is_left());
}

TEST_F(a_board, that_says_nothing_any_more_releases_after_the_hold_over) {
  ASSERT_NO_FATAL_FAILURE(drive(connected(2)));
  send(SIGSTOP, board);
  ASSERT_TRUE(reaches("released")) << ended();
  const outcome o = interrupt();
  EXPECT_EQ(o.status, 3);
  expect_released_at_the_end("encoders: no sample");
}

TEST_F(a_board, and_a_force_sensor_go_together_until_the_sensor_falls_silent) {
  net_ft_peer peer;
  settings both = connected(2);
  both.top = "law = \"direct_control\"";
  both.sensor =
      "type = \"net_ft\"\nhost = \"127.0.0.1\"\nopen_timeout = 20\nport = " + std::to_string(peer.port());
  ASSERT_NO_FATAL_FAILURE(drive(both));
  peer.fall_silent();
  ASSERT_TRUE(reaches("released")) << ended();
  const outcome o = interrupt();
  EXPECT_EQ(o.status, 3);
  EXPECT_TRUE(has(o.out, "brakes released: force sensor: no sample")) << o.out;
  expect_released_at_the_end("force sensor: no sample");
}

TEST_F(a_board, can_be_tried_with_the_shipped_configuration) {
  net_ft_peer peer;
  plug_in();
  std::string text = text_of(shipped + "/serial.toml");
  const auto put = [&](const std::string& old, const std::string& now) {
    ASSERT_NE(text.find(old), std::string::npos) << old;
    text.replace(text.find(old), old.size(), now);
  };
  put("\"/dev/ttyACM0\"", "\"brakes\"");
  put("\"192.168.1.1\"", "\"127.0.0.1\"");
  put("49152", std::to_string(peer.port()));
  put("pose = ", "max_gap = 5\nduration = 0.1\npose = ");
  put("priority = 80\nlock_memory = true", "max_overruns = 1000000\nmax_sleep = 10");
  put("supervisor_priority = 81", "hold_over = 5\nsupervisor_timeout = 5");
  file("c.toml", text);
  start({"--config", "c.toml", "--quiet"});
  EXPECT_TRUE(reaches("active")) << ended()
                                 << "the board's hand rests now and then, and the driver finds its home";
  send(SIGINT);
  end();
}

TEST_F(a_board, that_is_driven_refuses_a_second_driver_and_the_first_goes_on) {
  plug_in();
  start(connected());
  std::size_t row = 0;
  ASSERT_TRUE(reaches("active", 0, &row)) << ended();
  const pid_t first = pid;
  settings second = connected();
  second.top += "\nlog = \"\"";
  file("second.toml", second.text());
  EXPECT_EQ(status_of(spawn({driver, "--config", "second.toml"}, "second")), 1);
  EXPECT_TRUE(has(text_of(directory / "second.err"), "another program drives it"))
      << text_of(directory / "second.err");
  const std::size_t so_far = log().size();
  ASSERT_TRUE(eventually([&] { return log().size() > so_far + 300; }));
  send(SIGINT, first);
  const outcome o = end();
  EXPECT_EQ(o.status, 0) << o.out << o.err;
  const log_file all = log();
  for (std::size_t i = row; i + 1 < all.size(); ++i)
    ASSERT_TRUE(all.text(i, "state") == "active" || all.text(i, "state") == "degraded") << i;
}

TEST_F(a_board, that_is_silent_from_the_start_is_named) {
  plug_in();
  send(SIGSTOP, board);
  settings s = connected();
  s.sections = "[port]\ntype = \"serial\"\ndevice = \"brakes\"\nopen_timeout = 0.3\n";
  start(s);
  const outcome o = end();
  EXPECT_EQ(o.status, 1);
  EXPECT_TRUE(has(o.err, "error: serial port brakes: ")) << o.err;
}

}  // namespace
