// The driver with a board on a pseudo-terminal and a force sensor on the loopback interface.
#include "net_ft_peer.hpp"
#include "program.hpp"

namespace devices_tests {

using namespace program;

struct a_board : a_driver_at_a_terminal {
  pid_t board = -1;

  // Its watchdog has time, as this machine may have none, and the 1000 samples that may be missing last for 4
  // s: of a pseudo-terminal the kernel may make the port's thread wait.
  void plug_in() {
    board =
        spawn({board_program, "--link", "brakes", "--watchdog", "20000", "--period", "10000"}, "firmware");
    ASSERT_TRUE(eventually([this] { return fs::is_symlink(directory / "brakes"); }));
  }
  void drive(const settings& s) {
    plug_in();
    start(s);
    ASSERT_TRUE(reaches("active")) << ended();
  }
  static settings connected(double hold_over = 5) {
    return {.hold_over = hold_over,
            .top = "law.type = \"no_direct_control\"",
            .sections = "[port]\ntype = \"serial\"\ndevice = \"brakes\"\nopen_timeout = 20\n",
            .sensor = "type = \"none\""};
  }
};

TEST_F(a_board, that_is_gone_releases_at_once) {
  ASSERT_NO_FATAL_FAILURE(drive(connected()));
  send(SIGKILL, board);
  ASSERT_TRUE(reaches("released")) << ended();
  const outcome o = interrupt();
  EXPECT_EQ(o.status, 3);
  EXPECT_TRUE(has(o.out, "device lost")) << o.out;
  EXPECT_TRUE(has(o.out, "start again in the home pose")) << o.out;
  EXPECT_TRUE(has(log().text(log().size() - 1, "reason"), "device lost"));
  EXPECT_TRUE(nothing_is_left());
}

TEST_F(a_board, and_a_force_sensor_go_together_until_the_sensor_falls_silent) {
  net_ft_peer peer;
  settings both = connected(2);
  both.top = "law.type = \"direct_control\"";
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

}  // namespace devices_tests
