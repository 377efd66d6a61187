#include "program.hpp"

#include <sys/stat.h>

namespace running_tests {

using namespace program;

struct a_running_driver : a_driver {};

TEST_F(a_running_driver, homes_tares_displays_the_wall_and_leaves_a_whole_log) {
  const outcome o = run(settings{.hand_start = 2}.text(), {"--seconds", "3.5"});
  EXPECT_EQ(o.status, 0) << o.err;
  std::istringstream err(o.err);
  for (std::string line; std::getline(err, line);)
    EXPECT_TRUE(line.starts_with("remark: "))
        << line << ": the settings of a loaded machine are all it names";
  for (const char* part : {" cycles, ", "late     mean ", "compute  mean ", "  up to ",
                           "brakes released: as requested", "log: brake_driver.csv, 0 cycles lost"})
    EXPECT_TRUE(has(o.out, part)) << part << "\n" << o.out;
  EXPECT_FALSE(fs::exists(part_path()));

  const log_file all(log_path());
  ASSERT_TRUE(all.is_whole());
  EXPECT_TRUE(has(o.out, "\n" + std::to_string(all.size()) + " cycles, ")) << "none lost";
  bool was_active = false, braked = false;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i > 0) {
      ASSERT_GT(all.number(i, "cycle"), all.number(i - 1, "cycle"));
      ASSERT_GT(all.number(i, "t"), all.number(i - 1, "t"));
    }
    const std::string state = all.text(i, "state");
    const bool on = state == "active" || state == "degraded";
    ASSERT_TRUE(on || (state == "ready" && !was_active)) << state;
    was_active = was_active || on;
    for (const char* brake : {"current1", "current2"}) {
      const double current = all.number(i, brake);
      ASSERT_TRUE(current >= 0 && current <= 1) << current;
      ASSERT_TRUE(on || current == 0) << state;
      braked = braked || current > 0;
    }
  }
  EXPECT_TRUE(was_active);
  EXPECT_TRUE(braked);
  EXPECT_NEAR(all.number(0, "current1"), 0, 0);
}

// In the plane and in space, with more brakes or joints than dimensions.
TEST_F(a_running_driver, takes_any_mechanism) {
  for (const std::string& device : {
           std::string("[mechanism]\ntype = \"five_bar_with_four_brakes\"\n[sensor]\nlink = [0, 0]\n"
                       "[homing]\npose = [1.9, 1.2]\n"),
           std::string("[mechanism]\ntype = \"delta\"\n[homing]\n"),
       }) {
    const outcome o =
        run(device +
                "duration = 0.1\ntolerance = 1e6\n[safety]\nhold_over = 5\nsupervisor_timeout = 5\n"
                "[loop]\nmax_overruns = 1000000\nmax_sleep = 10\n",
            {"--seconds", "2", "--quiet"});
    EXPECT_EQ(o.status, 0) << o.out << o.err;
    EXPECT_EQ(log().text(log().size() - 1, "state"), "active") << device;
    EXPECT_EQ(log().text(log().size() - 1, "status"), "ok") << device;
  }
}

TEST_F(a_running_driver, keeps_the_shipped_configurations_promise) {
  for (const char* name : {"simulated.toml", "xy_table.toml"}) {
    const outcome o = run({"--config", shipped + "/" + name, "--seconds", "0.2"});
    EXPECT_TRUE(has(o.out, " cycles, ")) << name << o.out << o.err;
  }
  fs::remove(log_path());
  file("brake_driver.csv", "of a run before");
  const outcome comedi = run({"--config", shipped + "/comedi.toml", "--quiet"});
  EXPECT_EQ(comedi.status, PASSIVE_HAPTICS_HAS_COMEDI ? 1 : 2);
  EXPECT_TRUE(has(comedi.err, PASSIVE_HAPTICS_HAS_COMEDI ? "/dev/comedi0" : "libcomedi-dev")) << comedi.err;
  std::string text = text_of(shipped + "/serial.toml");
  const outcome serial = run(text.replace(text.find("/dev/ttyACM0"), 12, "/dev/tty_none"), {"--quiet"});
  EXPECT_EQ(serial.status, 1);
  EXPECT_TRUE(serial.err.starts_with("error: serial port /dev/tty_none: no such file; ")) << serial.err;
  EXPECT_EQ(text_of(log_path()), "of a run before") << "where nothing ran, the log stays";
  EXPECT_FALSE(fs::exists(part_path()));
  EXPECT_TRUE(nothing_is_left());
  // Without what it asks of the kernel: as root it would be granted
  text.erase(text.find("[loop]"));
  const outcome simulated = run(text, {"--simulate", "--seconds", "0.2", "--quiet"});
  EXPECT_TRUE(has(simulated.out, " cycles, ")) << simulated.out << simulated.err;
}

TEST_F(a_running_driver, says_before_anything_starts_that_it_cannot_write_its_log) {
  const outcome o = run("log = \"nowhere/log.csv\"", {});
  EXPECT_EQ(o.status, 1);
  EXPECT_EQ(
      o.err,
      "error: cannot write 'nowhere/log.csv.part': No such file or directory: expected a folder that is "
      "there and where you may write\n");
  EXPECT_EQ(o.out, "");
}

// Links, so that a driver that replaces them harms nothing.
TEST_F(a_running_driver, replaces_no_device_by_its_log) {
  fs::create_symlink("/dev/null", directory / "null.csv");
  ASSERT_EQ(mkfifo((directory / "fifo.csv").c_str(), 0600), 0);
  for (const auto& [name, kind] : {std::pair{"null.csv", "a device"}, {"fifo.csv", "a FIFO"}}) {
    const outcome o = run(std::string("log = \"") + name + "\"\n" + settings{}.text(), {"--seconds", "0.1"});
    EXPECT_EQ(o.status, 1) << o.out;
    EXPECT_TRUE(o.err.ends_with(std::string("error: cannot write '") + name + "': it is " + kind +
                                ": expected a regular file or a free name; choose another name\n"))
        << o.err;
    EXPECT_FALSE(fs::is_regular_file(directory / name));
  }
}

TEST_F(a_running_driver, says_what_becomes_of_the_currents_whoever_dies) {
  const outcome o = run("[safety]\nat_release = \"ramp\"\nramp_time = 0.7\nsupervisor_timeout = 0.4\n",
                        {"--seconds", "0.1", "--quiet"});
  EXPECT_TRUE(has(o.out,
                  "at a release: down to 0 A within 0.7 s; if the loop dies or stops, its supervisor does so "
                  "after 0.5 s at most\nif both do: the device's watchdog releases the brakes after 1 s\n"))
      << o.out;
}

TEST_F(a_running_driver, refuses_to_keep_currents_where_no_watchdog_ends_them) {
  std::string card = text_of(shipped + "/comedi.toml");
  card.insert(card.find("[safety]\n") + 9, "at_release = \"hold\"\n");
  const outcome comedi = check(card);
  EXPECT_EQ(comedi.status, 2);
  EXPECT_TRUE(
      has(comedi.err, "safety.at_release = 'hold': expected \"zero\": a card under Comedi has no watchdog"))
      << comedi.err;
  // It would let go before the supervisor could ramp
  const outcome late =
      run("[safety]\nat_release = \"ramp\"\nsupervisor_timeout = 0.9\n", {"--seconds", "0.1"});
  EXPECT_EQ(late.status, 2);
  EXPECT_TRUE(
      has(late.err,
          "error: [safety] supervisor_timeout [s] = 0.9: expected less than 0.8 of the device's watchdog, "
          "1, or at_release = \"zero\""))
      << late.err;
  EXPECT_FALSE(fs::exists(part_path()));
  EXPECT_TRUE(nothing_is_left());
}

TEST_F(a_running_driver, makes_the_folder_of_its_log) {
  const outcome o = run(settings{}.text(), {"--seconds=0.1", "--output=there/too", "--quiet"});
  EXPECT_EQ(o.status, 0) << o.err;
  EXPECT_TRUE(has(o.out, "log: there/too/brake_driver.csv, 0 cycles lost")) << o.out;
  EXPECT_TRUE(log_file(directory / "there/too/brake_driver.csv").is_whole());
}

TEST_F(a_running_driver, writes_no_log_where_none_is_wanted) {
  const outcome o = run(settings{.top = "log = \"\""}.text(), {"--seconds", "0.3"});
  EXPECT_EQ(o.status, 0) << o.err;
  EXPECT_FALSE(has(o.out, "log:"));
  EXPECT_FALSE(fs::exists(log_path()) || fs::exists(part_path()));
}

}  // namespace running_tests
