// The log of a run: what is not known is empty, replay makes the same decisions of it, and who draws it gets
// it as it comes.
#include "../loopback_socket.hpp"
#include "program.hpp"

#include <array>
#include <memory>

namespace logs_tests {

using namespace program;

struct a_log : a_driver {
  outcome replay(const words& arguments) {
    words command{PASSIVE_HAPTICS_REPLAY};
    command.insert(command.end(), arguments.begin(), arguments.end());
    const int status = status_of(spawn(command, "replay"));
    return {status, text_of(directory / "replay.out"), text_of(directory / "replay.err")};
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
      return replay(
          {"--config=device.toml", std::string("--input=") + input, std::string("--output=") + output});
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
    const outcome o =
        replay({"--config=brake_driver.device.toml", "--input=brake_driver.csv", "--output=again"});
    ASSERT_EQ(o.status, 0) << o.err;
    const log_file all = log();
    std::size_t decisions = 0, driven_brakes = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      decisions += !all.text(i, "capacity1").empty();
      driven_brakes += all.number(i, "capacity1") > 0 || all.number(i, "capacity2") > 0;
    }
    EXPECT_GT(driven_brakes, 100U) << "of " << decisions << " decisions";
    const std::string number = std::to_string(decisions);
    EXPECT_TRUE(has(o.out, "to the last digit: " + number + " of " + number + "\n")) << sections << o.out;
    EXPECT_EQ(log_file(directory / "again/replay.csv").size(), all.size());
  }
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
  file("wrong.toml", "[mechanism]\nlength_1 = -1\n");
  file("key.toml", "homeing = 1\n");
  for (const auto& [arguments, status, message] : {
           std::tuple{words{"--input=a.csv"}, 1,
                      "error: a.csv, line 2, column 7: 'x', expected a finite number for 'Fh_y'\n"},
           {words{"--input=none.csv"}, 1, "error: cannot read 'none.csv'\n"},
           {words{"--config=none.toml"}, 2, "error: none.toml: no such file\n"},
           {words{"--config=wrong.toml"}, 2,
            "error: wrong.toml:2: [mechanism] length_1 [m] = -1, expected a finite number > 0\n"},
           {words{"--config=key.toml"}, 2,
            "error: key.toml:1: unknown key 'homeing', expected one of allow_large, brakes, effects, "
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

}  // namespace logs_tests
