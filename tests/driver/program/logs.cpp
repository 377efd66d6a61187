// The log of a run: what is not known is empty, replay makes the same decisions of it, and who draws it gets
// it as it comes.
#include "../loopback_socket.hpp"
#include "program.hpp"

#include <array>
#include <cmath>
#include <memory>
#include <numbers>

namespace logs_tests {

using namespace program;

struct a_log : a_driver {
  outcome replay(const words& arguments) {
    words command{PASSIVE_HAPTICS_REPLAY};
    command.insert(command.end(), arguments.begin(), arguments.end());
    const int status = status_of(spawn(command, "replay"));
    return {status, text_of(directory / "replay.out"), text_of(directory / "replay.err")};
  }
  // All capacities, of the log that the driver left and its device file, and some of them above 0.
  void expect_all_as_in_the_log(const outcome& replayed) const {
    EXPECT_TRUE(replayed.out.starts_with("device: brake_driver.device.toml\n"))
        << replayed.out << replayed.err;
    const log_file all = log();
    std::size_t decisions = 0, driven_brakes = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      decisions += !all.text(i, "capacity1").empty();
      driven_brakes += all.number(i, "capacity1") > 0 || all.number(i, "capacity2") > 0;
    }
    EXPECT_GT(driven_brakes, 100U) << "of " << decisions << " decisions";
    const std::string number = std::to_string(decisions);
    EXPECT_TRUE(has(replayed.out, "to the last digit: " + number + " of " + number + "\n")) << replayed.out;
  }
};

// Nothing is at 5145.8 rad, and an offset is no force.
TEST_F(a_log, is_empty_where_nothing_is_known_yet) {
  ASSERT_EQ(run(settings{}.text(), {"--seconds=1", "--quiet"}).status, 0);
  const log_file all = log();
  std::size_t i = 0;
  const auto is_empty = [&](const char* name) { return all.text(i, name).empty(); };
  const auto expect = [&](bool homed, bool tared, bool asked) {
    for (const char* name : {"q1", "q2", "qd1", "qd2", "x", "y"})
      EXPECT_EQ(is_empty(name), !homed) << name << i;
    for (const char* name : {"Fh_x", "Fh_y"}) EXPECT_EQ(is_empty(name), !tared) << name << i;
    for (const char* name :
         {"status", "power", "display", "gamma", "alpha", "Fd_x", "Fc_y", "capacity1", "torque2"})
      EXPECT_EQ(is_empty(name), !asked) << name << i;
    for (const char* name : {"t", "cycle", "state", "current1", "current2", "late", "compute"})
      EXPECT_FALSE(is_empty(name)) << name << i;
  };
  expect(false, false, false);
  while (i < all.size() && is_empty("q1")) ++i;
  ASSERT_LT(i, all.size());
  EXPECT_NEAR(all.number(i, "q1"), 1.8812, 1e-3);
  expect(true, false, false);
  while (i < all.size() && is_empty("Fh_x")) ++i;
  ASSERT_LT(i, all.size());
  EXPECT_NEAR(all.number(i, "Fh_x"), 0, 0.5);
  i = all.size() - 1;
  expect(true, true, true);
}

TEST_F(a_log, names_its_version_and_units) {
  run("[mechanism]\ntype = \"xy_table\"\n[homing]\nduration = 0.1\n", {"--seconds=0.2", "--quiet"});
  std::istringstream in(text_of(log_path()));
  std::string version, units, names;
  std::getline(in, version);
  std::getline(in, units);
  std::getline(in, names);
  EXPECT_EQ(version, "# passive_haptics log 1");
  EXPECT_EQ(units, "# units: s,m,m,m/s,m/s,N,N,,,,rad,1,N,N,N,N,N,N,N,N,1,,,,m,m,A,A,s,s");
  EXPECT_EQ(
      names,
      "t,q1,q2,qd1,qd2,Fh_x,Fh_y,status,power,display,gamma,alpha,Fd_x,Fd_y,Fc_x,Fc_y,capacity1,capacity2,"
      "torque1,torque2,cycle,state,reason,held_over,x,y,current1,current2,late,compute");
}

TEST_F(a_log, replays_to_the_same_decisions_to_the_last_digit) {
  for (const char* law : {"direct_control", "velocity_direct_control"}) {
    const settings s{.hand_start = 0.5,
                     .top = std::string("law.type = \"") + law + "\"",
                     .sections = "[mechanism]\nlength_1 = 0.151\n[brakes]\nrate_dead_band = 0.03\n"};
    ASSERT_EQ(run(s.text(), {"--seconds=2", "--quiet"}).status, 0);
    const auto replayed_from = [&](const char* input, const char* output, const char* length = "0.151") {
      file("device.toml", std::string("[mechanism]\nlength_1 = ") + length +
                              "\n[brakes]\nrate_dead_band = 0.03\n[law]\ntype = \"" + law + "\"\n");
      return replay({input, "--config=device.toml", std::string("--output=") + output});
    };
    const outcome o = replayed_from("brake_driver.csv", "once");
    ASSERT_EQ(o.status, 0) << o.err;
    const log_file logged = log(), replayed(directory / "once/replay.csv");
    ASSERT_EQ(replayed.size(), logged.size());
    std::size_t decisions = 0, in_contact = 0;
    for (std::size_t i = 0; i < logged.size(); ++i) {
      for (const char* name :
           {"t",     "q1",    "q2",   "qd1",  "qd2",  "Fh_x", "Fh_y",      "status",    "power",   "display",
            "gamma", "alpha", "Fd_x", "Fd_y", "Fc_x", "Fc_y", "capacity1", "capacity2", "torque1", "torque2"})
        ASSERT_EQ(replayed.text(i, name), logged.text(i, name)) << law << ", line " << i << ", " << name;
      decisions += !logged.text(i, "capacity1").empty();
      in_contact += logged.number(i, "Fd_y") < 0;
    }
    EXPECT_GT(in_contact, 100U) << "of " << decisions << " decisions";
    const std::string same = std::to_string(decisions) + " of " + std::to_string(decisions);
    EXPECT_TRUE(has(o.out, "capacities as in the log, to the last digit: " + same)) << o.out;
    // Its own output is a log
    ASSERT_EQ(replayed_from("once/replay.csv", "twice").status, 0);
    EXPECT_TRUE(text_of(directory / "twice/replay.csv") == text_of(directory / "once/replay.csv"));
    // Of another arm they differ
    EXPECT_FALSE(has(replayed_from("brake_driver.csv", "other", "0.15").out, same));
  }
}

// Limits and dead bands come from the calibration, a lead from the brakes.
TEST_F(a_log, comes_with_a_device_file_that_replays_it) {
  const std::string mechanism = "[mechanism]\nlength_1 = 0.151\n";
  struct device {
    std::string top, sections, sensor;
  };
  const device devices[] = {
      {"", mechanism, ""},
      {"law.type = \"saturated_direct_control\"", "[brakes]\ntable_1 = [[0, 0], [0.5, 0.3], [1, 0.9]]\n", ""},
      {"", "[[walls]]\n[[walls]]\ntype = \"capsule\"\nfrom = [0.1, 0.3]\nto = [0.2, 0.3]\nradius = 0.0745\n",
       "type = \"none\""},
      {"law.type = \"direct_control\"",
       "[mechanism]\ntype = \"two_link\"\n[[brakes.model]]\n[[brakes.model]]\ntype = \"magnetorheological\"\n"
       "[[effects]]\ntype = \"viscous_field\"\nviscosity = [[5, 0], [0, 5]]\n[[walls]]\n[scene]\nperiod = "
       "0.01\n",
       ""}};
  for (const auto& [top, sections, sensor] : devices) {
    const settings s{.hand_start = 0.5, .top = top, .sections = sections, .sensor = sensor};
    const outcome driven = run(s.text(), {"--seconds=2", "--quiet"});
    ASSERT_EQ(driven.status, 0) << driven.err;
    const fs::path device_file = directory / "brake_driver.device.toml";
    EXPECT_TRUE(has(driven.out, "device: brake_driver.device.toml\n")) << driven.out;
    ASSERT_TRUE(fs::exists(device_file));
    EXPECT_FALSE(fs::exists(device_file.string() + ".part"));
    const outcome o = replay({"brake_driver.csv", "--output=again"});
    ASSERT_EQ(o.status, 0) << o.err;
    expect_all_as_in_the_log(o);
    EXPECT_EQ(log_file(directory / "again/replay.csv").size(), log().size());
  }
}

// With the memory of a law from before the release, a tenth of the capacities would be others.
TEST_F(a_log, of_encoders_on_pulleys_has_their_resolution) {
  const std::string pulleys = R"(
[encoders]
slides = [false, false]        # one for each axis
counts_per_turn = 8192
)";
  settings s{.hand_start = 1, .top = "mechanism.type = \"xy_table\"", .sections = pulleys};
  const outcome o = run(s.text(), {"--seconds", "2", "--quiet"});
  EXPECT_EQ(o.status, 0) << o.err;
  const log_file all = log();
  std::size_t first = 0;
  while (all.text(first, "q1").empty()) ++first;
  constexpr double count = 2 * std::numbers::pi / 8192;  // [m]
  double most = 0;
  for (std::size_t i = first; i < all.size(); ++i) {
    const double counts = (all.number(i, "q1") - all.number(first, "q1")) / count;
    ASSERT_NEAR(counts, std::round(counts), 1e-6) << i;
    most = std::max(most, counts);
  }
  EXPECT_GT(most, 5);
}

TEST_F(a_log, of_a_run_with_rearms_replays_to_the_same_decisions) {
  start(settings{.max_sleep = 0.4, .hand_start = 0.3, .start_depth = 0.1, .top = ""});
  std::size_t row = 0;
  for (int release = 0; release < 2; ++release) {
    ASSERT_TRUE(reaches("active", row, &row)) << ended();
    ASSERT_TRUE(eventually([&] { return log().size() > row + 800; }));
    freeze(0.8);
    ASSERT_TRUE(reaches("released", row, &row)) << ended();
    ASSERT_TRUE(eventually([&] {
      send(SIGUSR1);
      const log_file all = log();
      return all.size() > 1 && all.text(all.size() - 2, "state") == "active";
    })) << ended();
  }
  ASSERT_TRUE(eventually([&] { return log().size() > row + 800; }));
  EXPECT_EQ(interrupt().status, 3);
  expect_all_as_in_the_log(replay({"brake_driver.csv"}));
}

// As the last step of the tutorial makes it.
TEST_F(a_log, of_a_mechanism_and_a_law_from_outside_replays_to_the_same_decisions) {
  const std::string program = PASSIVE_HAPTICS_BOTH_PROGRAMS;
  std::string text = text_of(std::string(PASSIVE_HAPTICS_GUIDE_DIR) + "/step_9_programs.toml");
  text +=
      "duration = 0.1\ntolerance = 1e6\nmax_gap = 5\n[loop]\nmax_overruns = 1000000\nmax_sleep = 10\n"
      "[safety]\nhold_over = 5\nsupervisor_timeout = 5\n[simulation]\nhand_start = 0.5\n";
  file("scara.toml", text);
  pid = spawn({program, "--config", "scara.toml", "--seconds=2", "--quiet"}, "driver");
  const outcome driven = end();
  EXPECT_EQ(driven.status, 0) << driven.err;
  EXPECT_EQ(driven.err, "");
  ASSERT_EQ(status_of(spawn({program, "replay", "brake_driver.csv"}, "replay")), 0)
      << text_of(directory / "replay.err");
  expect_all_as_in_the_log({0, text_of(directory / "replay.out"), ""});
}

TEST_F(a_log, is_not_begun_where_its_device_file_cannot_be) {
  fs::create_directory(directory / "brake_driver.device.toml");
  const outcome o = run({"--seconds=1", "--quiet"});
  EXPECT_EQ(o.status, 1);
  EXPECT_TRUE(has(o.err, "cannot write 'brake_driver.device.toml': it is a directory")) << o.err;
  EXPECT_FALSE(fs::exists(log_path()) || fs::exists(part_path()));
}

TEST_F(a_log, that_is_wrong_is_named_with_file_line_and_column) {
  file("a.csv", "t,q1,q2,qd1,qd2,Fh_x,Fh_y\n0,1,2,3,4,5,x\n");
  file("c.toml", "law.type = \"direct_control\"\n");
  file("wrong.toml", "[mechanism]\nlength_1 = -1\n");
  file("key.toml", "homeing = 1\n");
  for (const auto& [arguments, status, message] : {
           std::tuple{words{"a.csv", "--config=c.toml"}, 1,
                      "error: a.csv, line 2, column 7: 'x': expected a finite number for 'Fh_y'\n"},
           {words{"none.csv"}, 1, "error: cannot read 'none.csv': No such file or directory\n"},
           {words{"a.csv"}, 2,
            "error: a.device.toml: no such file: expected the device file that brake_driver wrote next to "
            "a.csv; give the device of the log by --config FILE\n"},
           {words{"--config=none.toml"}, 2, "error: none.toml: no such file\n"},
           {words{"--config=wrong.toml"}, 2,
            "error: wrong.toml:2: [mechanism] length_1 [m] = -1: expected a finite number > 0\n"},
           {words{"--config=key.toml"}, 2,
            "error: key.toml:1: unknown key 'homeing': expected one of allow_large, brakes, effects, "
            "encoders, "
            "homing, "
            "law, log, loop, mechanism, port, safety, scene, sensor, simulation, walls; did you mean "
            "\"homing\"?\n"},
       }) {
    const outcome o = replay(arguments);
    EXPECT_EQ(o.status, status) << message;
    EXPECT_EQ(o.err, message);
    EXPECT_EQ(o.out, "");
    EXPECT_FALSE(fs::exists(directory / "replay.csv") || fs::exists(directory / "replay.csv.part"));
  }
  EXPECT_EQ(replay({"--help"}).out, text_of(shipped + "/../help/05_replay.txt"));
}

// All that brake_driver reads besides.
TEST_F(a_log, is_replayed_with_the_file_of_the_driver) {
  file("c.toml",
       "log = \"\"\nallow_large = [\"hold_over\"]\n[encoders]\nwindow = 16\n[homing]\nduration = 0.5\n"
       "[brakes]\ncurrent_limit = 1\ntable_1 = [[0, 0], [1, 1]]\n[sensor]\ntype = \"net_ft\"\nlink = [1, 1]\n"
       "[port]\ntype = \"serial\"\n[loop]\nperiod = 1e-3\n[safety]\nhold_over = 1e12\n[simulation]\npush = "
       "2\n");
  const outcome o = replay({"--config=c.toml"});
  EXPECT_EQ(o.status, 0) << o.err;
  EXPECT_EQ(o.err, "");
}

TEST_F(a_log, comes_live_as_json_to_a_port_of_this_machine) {
  auto socket = std::make_unique<loopback_socket>();
  file("c.toml", settings{}.text());
  start({"--config=c.toml", "--seconds=1", "--quiet", "--live=" + std::to_string(socket->port())});
  std::string first;
  int rows = 0;
  ASSERT_TRUE(eventually([&] {
    std::array<char, 4096> bytes;
    for (ssize_t n; (n = socket->receive(bytes.data(), bytes.size())) > 0;)
      if (rows++ == 0) first.assign(bytes.data(), static_cast<std::size_t>(n));
    return rows >= 100;
  })) << rows;
  socket.reset();  // nobody has to listen
  const outcome o = end();
  EXPECT_EQ(o.status, 0) << o.err;
  const log_file all = log();
  ASSERT_TRUE(all.is_whole());
  EXPECT_TRUE(first.starts_with("{\"t\":" + all.text(0, "t") + ",\"cycle\":")) << first;
  EXPECT_TRUE(first.ends_with(",\"compute\":" + all.text(0, "compute") + "}")) << first;
  EXPECT_TRUE(has(first, ",\"state\":\"ready\",")) << first;
}

// The device files that ship, with times that suit a busy machine.
TEST_F(a_log, of_each_shipped_device_replays) {
  const fs::path devices = fs::path(shipped) / "../catalogue/devices";
  fs::copy_file(devices / "part.stl", directory / "part.stl");
  for (const char* name : {"paper.toml", "five_bar.toml", "delta.toml"}) {
    const outcome driven = run(text_of(devices / name) +
                                   "\n[safety]\nhold_over = 5\nsupervisor_timeout = 5\n"
                                   "[loop]\nmax_overruns = 1000000\nmax_sleep = 10\n",
                               {"--seconds=4", "--quiet"});
    ASSERT_EQ(driven.status, 0) << name << driven.err;
    expect_all_as_in_the_log(replay({"brake_driver.csv", "--output=again"}));
  }
}

}  // namespace logs_tests
