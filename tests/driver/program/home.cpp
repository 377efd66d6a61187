// Where the handle is when the brakes come on.
#include "net_ft_peer.hpp"
#include "program.hpp"

#include <firmware/brake_controller.hpp>
#include <firmware/host_board.hpp>
#include <passive_haptics/brake/models/encoder_axes.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>

#include <cmath>
#include <numbers>

namespace home_tests {

using namespace program;
namespace ph = passive_haptics;
using arm = ph::tendon_two_link<double>;

struct a_home_pose : a_driver {};

TEST_F(a_home_pose, is_printed_with_its_distance_to_each_wall) {
  EXPECT_TRUE(run({"--check"})
                  .out.ends_with("direct_control\n"
                                 "home  q (1.88121, -1.30547) rad, handle at (0.0800, 0.2245) m\n"
                                 "wall 1 (half_space): 0.5 mm in front of it\n"));
  const std::string walls =
      "[[walls]]\nnormal = [0, 1]\n[[walls]]\ntype = \"ball\"\ncentre = [0.08, 0.3]\nradius = 0.05\n"
      "[[walls]]\ntype = \"ball\"\ncentre = [0.08, 0.14]\nradius = 0.0825\ninside = \"hollow\"\n"
      "[[walls]]\nsurface_point = [0, 0.3]\n[walls.motion]\namplitude = [0, 0.02]\nfrequency = 0.5\n";
  const std::string distances =
      "wall 1 (half_space): 0.5 mm inside it: check that its normal points to the free side\n"
      "wall 2 (ball): 25.5 mm in front of it\n"
      "wall 3 (ball): 2.0 mm inside it: check its inside (solid: free outside, hollow: free inside)\n"
      "wall 4 (half_space): 55.5 mm in front of it\n";  // at the end of its motion
  const outcome o = check(walls);
  EXPECT_EQ(o.status, 0) << o.err;
  EXPECT_TRUE(o.out.ends_with(distances)) << o.out;
  // When it starts, too
  EXPECT_TRUE(has(run({"--config", "c.toml", "--seconds", "0.1", "--quiet"}).out, distances));
  EXPECT_TRUE(has(check("[mechanism]\ntype = \"xy_table\"\n").out,
                  "home  q (0.08, 0.2245) m, handle at (0.0800, 0.2245) m\n"));
}

TEST_F(a_home_pose, deep_in_a_wall_is_refused_with_its_likely_cause) {
  const std::string sides =
      "; check that the pose is that of this device, in radians, not degrees, and the position of the wall\n";
  EXPECT_EQ(
      check("[homing]\npose = [107.785, -74.8]").err,
      "error: c.toml:2: [homing] pose = (107.785, -74.8) rad, handle at (0.0849, 0.2738) m, 48.8 mm "
      "inside wall 1 (half_space): expected at most max_start_depth, 5 mm; angles beyond a turn look like "
      "degrees: in radians they are (1.8812, -1.3055)\n");
  EXPECT_EQ(
      check("[[walls]]\n[[walls]]\nsurface_point = [0, 0.1]\nnormal = [0, 1]\n[[walls]]\nsurface_point = [0, "
            "0.25]\nnormal "
            "= [0, 1]\n[homing]\npose = [1.8812, -1.3055]")
          .err,
      "error: c.toml:9: [homing] pose = (1.8812, -1.3055) rad, handle at (0.0800, 0.2245) m, 25.5 mm "
      "inside wall 3 (half_space): expected at most max_start_depth, 5 mm; check that its normal points to "
      "the "
      "free side" +
          sides);
  EXPECT_EQ(check("[[walls]]\ntype = \"ball\"\ncentre = [0.08, 0.2345]\nradius = 0.05\n").err,
            "error: c.toml: [homing] pose = (1.88121, -1.30547) rad, handle at (0.0800, 0.2245) m, 40.0 mm "
            "inside wall 1 (ball): expected at most max_start_depth, 5 mm; check its inside (solid: "
            "free outside, hollow: free inside)" +
                sides);
}

TEST_F(a_home_pose, that_is_refused_opens_no_device) {
  file("c.toml", "[homing]\npose = [107.785, -74.8]");
  for (const char* option : {"--simulate", "--limits", "--quiet"}) {
    const outcome o = run({"--config", "c.toml", option});
    EXPECT_EQ(o.status, 2) << option;
    EXPECT_TRUE(has(o.err, "48.8 mm inside wall 1")) << o.err;
    EXPECT_EQ(o.out, "");
  }
  EXPECT_FALSE(fs::exists(log_path()) || fs::exists(part_path()));
}

TEST_F(a_home_pose, in_degrees_is_named_in_free_space_too) {
  EXPECT_TRUE(
      has(check("[homing]\npose = [-90, 10]").err,
          " m: expected angles within a turn; angles beyond a turn look like degrees: in radians they are "
          "(-1.5708, 0.1745)\n"));
  EXPECT_EQ(check("[homing]\npose = [-4.4, -1.3055]").status, 0);
}

TEST_F(a_home_pose, of_no_handle_is_refused) {
  const outcome o =
      check("[mechanism]\ntype = \"five_bar\"\n[sensor]\nlink = [0, 0]\n[homing]\npose = [3.1, 0]");
  EXPECT_EQ(o.status, 2);
  EXPECT_TRUE(
      has(o.err, "c.toml:6: [homing] pose = (3.1, 0) rad: expected a pose that the mechanism can take"))
      << o.err;
}

TEST_F(a_home_pose, may_be_as_deep_as_the_file_says) {
  const std::string deep = "[[walls]]\nsurface_point = [0, 0.2045]\n[homing]\n";
  EXPECT_EQ(check(deep).status, 2);
  const outcome o = check(deep + "max_start_depth = 0.03\n");
  EXPECT_EQ(o.status, 0) << o.err;
  EXPECT_TRUE(has(o.out, "wall 1 (half_space): 20.0 mm inside it: check")) << o.out;
  EXPECT_TRUE(has(check("[homing]\nmax_start_depth = 1").err,
                  "max_start_depth [m] = 1: expected at most 0.1; if it is meant, allow_large"));
}

// A device whose handle is where a test puts it, and which may fall silent.
class placed_device {
 public:
  explicit placed_device(const fs::path& link) {
    fs::create_symlink(line_.path(), link);
    thread_ = std::thread([this] { serve(); });
  }
  ~placed_device() {
    ended_ = true;
    thread_.join();
  }

  // This far from home along y [m].
  void put(double y) {
    const arm mechanism;
    const ph::encoder_axes<arm> axes(mechanism);
    const ph::vector<double, 2> home(1.8812, -1.3055), x = mechanism.position(home);
    const auto there = mechanism.inverse({x[0], x[1] + y}, ph::elbow::left).q;
    const ph::vector<double, 2> turned = axes.from_joints(there) - axes.from_joints(home);
    for (std::size_t i = 0; i < board_.count.size(); ++i)
      board_.count[i] =
          static_cast<int>(std::lround(turned[static_cast<int>(i)] * 8192 / (2 * std::numbers::pi)));
  }
  void fall_silent(bool is) { silent_ = is; }

 private:
  struct placed_board : firmware::host_board {
    using firmware::host_board::host_board;
    std::array<std::atomic<int>, 2> count{};
    std::int32_t read_encoder(std::size_t i) const { return count[i]; }
  };

  void serve() {
    firmware::brake_controller<placed_board> controller(board_, {.watchdog = 60'000, .period = 10'000});
    std::array<std::uint8_t, 8192> bytes;
    for (std::uint32_t now = 0; !ended_; usleep(10'000)) {
      now += 10'000;
      const std::size_t heard = line_.read(bytes);
      for (std::size_t i = 0; i < heard; ++i) controller.receive(bytes[i], now);
      if (!silent_) controller.tick(now);
    }
  }

  firmware::pseudo_terminal line_;
  placed_board board_{line_};
  std::thread thread_;
  std::atomic<bool> ended_ = false, silent_ = false;
};

struct a_handle : a_driver_at_a_terminal {
  static settings with(const net_ft_peer& sensor) {
    return {.hold_over = 2,
            .top = "law.type = \"no_direct_control\"",
            .sections = "[port]\ntype = \"serial\"\ndevice = \"brakes\"\nopen_timeout = 20\n",
            .sensor = "type = \"net_ft\"\nhost = \"127.0.0.1\"\nopen_timeout = 20\nport = " +
                      std::to_string(sensor.port())};
  }
  bool is_homed() {
    return has_row([](const log_file& all, std::size_t i) { return !all.text(i, "q1").empty(); });
  }
  bool is_deep() const {
    const log_file all = log();
    return all.size() > 1 && all.number(all.size() - 2, "y") > 0.235;
  }
  // Whether a row from this one on says that the brakes wait for the handle; then that row.
  bool waits(std::size_t from = 0, std::size_t* found = nullptr) {
    return has_row(
        [](const log_file& all, std::size_t i) {
          return all.text(i, "reason").starts_with("not activated: the handle is 1") &&
                 all.text(i, "state") == "ready";
        },
        from, found);
  }

  // Started, homed, and pushed into the wall before the sensor is tared.
  void waits_deep(net_ft_peer& sensor, placed_device& device) {
    sensor.tremble(true);
    start(with(sensor));
    ASSERT_TRUE(is_homed()) << ended();
    device.put(0.0125);
    ASSERT_TRUE(eventually([this] { return is_deep(); })) << ended();
    sensor.tremble(false);
    ASSERT_TRUE(waits()) << ended();
  }
};

TEST_F(a_handle, deep_in_a_wall_gets_no_brakes_and_the_end_says_so) {
  net_ft_peer sensor;
  placed_device device(directory / "brakes");
  ASSERT_NO_FATAL_FAILURE(waits_deep(sensor, device));
  ASSERT_TRUE(eventually([this] {
    return has(text_of(directory / "driver.out"), " s  ready, not activated: the handle is 1");
  }));
  const outcome o = interrupt();
  EXPECT_EQ(o.status, 0) << o.out << o.err;
  EXPECT_TRUE(has(o.out, "\nnot activated: the handle is 1")) << o.out;
  EXPECT_TRUE(has(o.out, " mm inside wall 1, more than max_start_depth; move it out\n")) << o.out;
  const log_file all = log();
  for (std::size_t i = 0; i < all.size(); ++i) ASSERT_NE(all.text(i, "state"), "active") << i;
}

TEST_F(a_handle, gets_brakes_once_it_is_out_and_after_a_rearm_too) {
  net_ft_peer sensor;
  placed_device device(directory / "brakes");
  ASSERT_NO_FATAL_FAILURE(waits_deep(sensor, device));
  device.put(0);
  std::size_t row = 0;
  ASSERT_TRUE(reaches("active", 0, &row)) << ended();
  EXPECT_LT(log().number(row, "y"), 0.2251);

  device.put(0.0125);
  ASSERT_TRUE(eventually([this] { return is_deep(); })) << "active brakes stay so: " << ended();
  device.fall_silent(true);
  ASSERT_TRUE(reaches("released", row, &row)) << ended();
  device.fall_silent(false);
  ASSERT_TRUE(eventually([&] {
    send(SIGUSR1);
    const log_file all = log();
    return all.size() > 1 && all.text(all.size() - 2, "state") == "ready";
  })) << ended();
  ASSERT_TRUE(waits(row, &row)) << ended();
  device.put(0);
  std::size_t again = 0;
  ASSERT_TRUE(reaches("active", row, &again)) << ended();
  const log_file all = log();
  for (std::size_t i = row; i < again; ++i) ASSERT_EQ(all.text(i, "state"), "ready") << i;
  EXPECT_LT(all.number(again, "y"), 0.2251);
  EXPECT_FALSE(has(interrupt().out, "\nnot activated"));
}

}  // namespace home_tests
