#include "program.hpp"

#include <sys/stat.h>

namespace configuration_tests {

using namespace program;

struct a_configuration : a_driver {
  struct mistake {
    std::string text, message;  // how it begins
  };
  void expect_named(const std::vector<mistake>& all) {
    for (const auto& [text, message] : all) {
      const outcome o = check(text);
      EXPECT_EQ(o.status, 2) << text;
      EXPECT_TRUE(o.err.starts_with("error: c.toml:" + message)) << text << "\n" << o.err;
      EXPECT_EQ(o.out, "") << text;
    }
  }
};

TEST_F(a_configuration, that_is_shipped_is_right) {
  int count = 0;
  for (const auto& one : fs::directory_iterator(shipped)) {
    if (one.path().extension() != ".toml") continue;
    const outcome o = run({"--config", one.path(), "--check"});
    EXPECT_EQ(o.status, 0) << one.path() << o.err;
    EXPECT_TRUE(has(o.out, " is valid: ")) << o.out;
    ++count;
  }
  EXPECT_GE(count, 4);
}

TEST_F(a_configuration, of_a_urdf_is_right_or_names_the_package_that_is_missing) {
  const outcome o = run({"--config", PASSIVE_HAPTICS_GUIDE_DIR "/urdf.toml", "--check"});
  if (has(o.err, "liburdfdom-dev")) return;
  EXPECT_EQ(o.status, 0) << o.err;
  EXPECT_TRUE(has(o.out, "urdf.toml is valid: spatial_chain_7_with_inertia, simulated device")) << o.out;
}

TEST_F(a_configuration, tells_what_its_wall_can_be) {
  for (const std::string mechanism : {"tendon_two_link\"\n", "two_link\"\n", "xy_table\"\n",
                                      "five_bar\"\n[homing]\npose = [1.9, 1.2]\n[sensor]\nlink = [0, 0]\n"}) {
    file("c.toml", "[mechanism]\ntype = \"" + mechanism);
    const outcome o = run({"--config", "c.toml", "--limits"});
    EXPECT_EQ(o.status, 0) << o.err;
    EXPECT_TRUE(has(o.out, "least noticeable drift")) << o.out;
  }
  const auto with_law = [this](const std::string& keys) {
    file("c.toml", "[law]\ntype = \"velocity_direct_control\"\n" + keys);
    return run({"--config", "c.toml", "--limits"}).out;
  };
  const std::string usual = with_law("");
  EXPECT_EQ(with_law("rate_lag = 0.004\n"), usual);
  EXPECT_NE(with_law("rate_lag = 0.02\n"), usual);
}

TEST_F(a_configuration, of_another_mechanism_or_without_a_file_is_right) {
  EXPECT_EQ(run({"--check"}).status, 0);
  EXPECT_EQ(run({"--help"}).out, text_of(shipped + "/../help/08_brake_driver.txt"));
  const outcome o =
      check("[mechanism]\ntype = \"five_bar\"\n[homing]\npose = [1.9, 1.2]\n[sensor]\nlink = [0, 0]\n");
  EXPECT_EQ(o.status, 0) << o.err;
  EXPECT_TRUE(o.out.starts_with(
      "c.toml is valid: five_bar, simulated device, simulated force sensor, velocity_direct_control\n"))
      << o.out;
}

TEST_F(a_configuration, that_is_wrong_is_named_with_file_line_key_value_and_expectation) {
  expect_named({
      {"laws = \"x\"", "1: unknown key 'laws': expected one of allow_large, brakes, "},
      {"[brakes]\ncurrent_limt = 1", "2: unknown key 'brakes.current_limt': expected one of "},
      {"[sensor]\ntype = \"none\"\nmounting = 1", "3: unknown key 'sensor.mounting': expected one of type"},
      {"mechanism = 3", "1: mechanism = 3: expected a table, [mechanism]"},
      {"[walls]\nsurface_point = [0, 1]", "1: walls = a table: expected tables, [[walls]] each"},
      {"log = 3", "1: log = 3: expected a text in quotes"},
      {"[brakes]\ncurrent_limit = \"1\"",
       "2: brakes.current_limit = '1': expected 2 numbers, or one for all"},
      {"[brakes]\ncurrent_limit = [1, 1, 1]",
       "2: brakes.current_limit = [ 1, 1, 1 ]: expected 2 numbers, or one"},
      {"[homing]\npose = [1.5, -1.5, []]", "2: homing.pose = [ 1.5, -1.5, [] ]: expected 2 numbers"},
      {"[brakes]\ncurrent_limit = -1",
       "2: [brakes] brakes[0].current_limit [A] = -1: expected a finite number > 0"},
      {"[brakes]\ncontinuous_current = inf",
       "1: [brakes] continuous[0] [A] = inf: expected a finite number > 0"},
      {"[brakes]\ntorque_lower = [-inf, 0.5]",
       "2: [brakes] torque_lower[1] [N m] = 0.5: expected a number <= 0, or -inf"},
      {"[brakes]\ntable_1 = [[0, 0], [1]]",
       "2: brakes.table_1 = [ [ 0, 0 ], [ 1 ] ]: expected pairs of numbers"},
      {"[encoders]\nwindow = 0.5", "2: encoders.window = 0.5: expected a whole number"},
      {"[encoders]\nslides = 1", "2: encoders.slides = 1: expected 2 times true or false, or one for all"},
      {"[loop]\nlock_memory = 1", "2: loop.lock_memory = 1: expected true or false"},
      {"[mechanism]\nlength_1 = \"x\"",
       "2: mechanism.length_1 = 'x': expected a number: a finite number > 0 [m]"},
      {"[mechanism]\ntype = \"five_bar\"\nassembly = \"up\"",
       "3: mechanism.assembly = 'up': expected one of \"left\", \"right\""},
      {"[loop]\nperiod = 0", "2: [loop] period [s] = 0: expected 1e-6 to 1"},
      {"[safety]\nat_release = \"off\"",
       "2: safety.at_release = 'off': expected one of \"zero\", \"ramp\", \"hold\""},
      {"[loop]\nperiod = 0.1\n[safety]\nhold_over = 0.1",
       "4: [safety] hold_over [s] = 0.1: expected at least 2 times the period of [loop]"},
      {"[safety]\nsupervisor_timeout = 0.001",
       "1: [safety] timeout of the supervisor [s] = 0.001: expected 0.004"},
      {"[simulation]\ndirection = [nan, 1]", "2: [simulation] |direction| = nan: expected a direction"},
      {"[sensor]\nlink = [1, inf]", "2: [sensor] link[1] [1] = inf: expected a finite number"},
      {"[sensor]\nmounting = -90",
       "2: [sensor] mounting [rad] = -90: expected at most 6.28319; this looks like degrees: in radians "
       "it is -1.5708; if it is meant, allow_large = [\"mounting\"]\n"},
      {"[[walls]]\nsurface_point = 0",
       "2: walls[0].surface_point = 0: expected 2 numbers: a finite number [m]\n"},
      {"[simulation]\ndirection = 1", "2: simulation.direction = 1: expected 2 numbers: a direction [1]\n"},
      {"[[walls]]\nstiffness = -1",
       "2: [walls[0]] stiffness of a wall [N/m] = -1: expected a finite number >= 0\n"},
      {"[homing]\nmax_start_depth = inf",
       "2: [homing] max_start_depth [m] = inf: expected a finite number >= 0"},
      {"[homing]\npose = [inf, 0]", "2: [homing] pose[0] [rad or m] = inf: expected a finite number"},
      {"[mechanism]\ntype = \"five_bar\"",
       " [homing] pose is missing: expected joint positions at the start"},
      {"[[walls]]\n[[walls]]\nnormal = [0, 0]", "3: [walls[1]] "},
      {"law.type = \"direct_control\"\n[sensor]\ntype = \"none\"",
       "1: law.type = 'direct_control': expected one of \"on_off_control\", \"no_direct_control\": "
       "direct_control needs a hand force, and [sensor] has type = \"none\"\n"},
      {"[port]\ntype = \"serial\"",
       "1: [port] type = \"serial\" and [sensor] type = \"simulated\": expected both"},
      {"[port]\ntype = \"serial\"\nbaud = 1234", "3: [port] baud [bit/s] = 1234: expected one of 9600, "},
      {"[port]\ntype = \"comedi\"\namperes_per_volt = 0", "3: [port] brakes[0].amperes_per_volt [A/V]"},
      {"\n[homing]\npose = [2.8, -0.1", "3: Error while parsing array"},
      {"[brakes]\n[brakes]", "2: Error while parsing table header"},
      {"[simulation]\nseed = -1", "2: [simulation] seed = -1: expected a whole number >= 0"},
      {"log = \"brake\\u0000driver.csv\"", "1: log = "},
      {"\"a\\u0000\\u001b[2J\" = 1", "1: unknown key 'a??[2J': expected one of "},
      {"\nl\u00e4nge = 1", "2: Error while parsing key-value pair"},
  });
}

// One without inertia can be driven, not simulated; a force sensor in space stays on a handle that does not
// rotate.
TEST_F(a_configuration, takes_each_mechanism_that_it_can_drive) {
  const std::string arm =
      "[mechanism]\ntype = \"planar_chain_2\"\nhandle = [0.3, 0]\n[[mechanism.joints]]\npoint = [0, 0]\n"
      "[[mechanism.joints]]\npoint = [0.15, 0]\n[homing]\npose = [1.8812, -1.3055]\n";
  const std::string joint = "[[mechanism.joints]]\naxis = [0, 0, 1]\n",
                    arm_in_space = "[mechanism]\ntype = \"spatial_chain_3\"\nhandle = [0.3, 0, 0]\n" + joint +
                                   joint + joint + "[homing]\npose = 0.1\n";
  expect_named({
      {"[mechanism]\ntype = \"five_bar_with_four_brakes\"\n[homing]\npose = [1.9, 1.2]\n[sensor]\ntype = "
       "\"none\"\n[port]\ntype = \"comedi\"",
       "8: port.type = 'comedi': expected \"simulated\" or \"serial\": a card supports two or three brakes "
       "with "
       "an encoder each\n"},
      {arm_in_space + "[sensor]\ntype = \"net_ft\"",
       "13: sensor.type = 'net_ft': expected \"none\": the handle of a spatial_chain_3 rotates, "
       "and the program supports no sensor that rotates with it\n"},
      {"[mechanism]\ntype = \"delta\"\n[sensor]\nlink = [1, 1, 1]",
       "4: unknown key 'sensor.link': expected one "},
      {arm,
       "1: [mechanism] type = \"planar_chain_2\": expected one with inertia, which a simulated device "
       "needs\n"},
      {"[[brakes.model]]",
       "1: brakes.model = [ a table ]: expected 2 tables [[brakes.model]], one for each "},
      {"[[brakes.model]]\n[[brakes.model]]\n[simulation]\nbrake_lag = 0.1",
       "4: simulation.brake_lag = 0.1: expected no lag in [simulation], as the file has [[brakes.model]]"},
  });
  const outcome o = check(arm + "[port]\ntype = \"serial\"\n[sensor]\ntype = \"none\"\n");
  EXPECT_EQ(o.status, 0) << o.err;
  EXPECT_TRUE(has(o.out, "planar_chain_2, serial device, none force sensor, on_off_control\n")) << o.out;
  EXPECT_EQ(
      run({"--config", "c.toml", "--simulate"}).err,
      "error: [mechanism] type = \"planar_chain_2\": expected one with inertia, which a simulated device "
      "needs\n");
  EXPECT_EQ(check("walls = []\n[[brakes.model]]\n[[brakes.model]]\ntype = \"stribeck\"\n").status, 0);
  EXPECT_EQ(run({"--config", "c.toml", "--limits"}).err,
            "error: walls = []: expected one or more for --limits, which is about the first\n");
}

TEST_F(a_configuration, with_an_old_key_gets_the_new_name) {
  expect_named({
      {"law = \"direct_control\"",
       "1: law = 'direct_control': expected a table, [law], with type = \"...\": the key was renamed\n"},
      {"[[wall]]\nnormal = [0, -1]", "1: wall = [ a table ]: expected [[walls]]: the key was renamed\n"},
      {"[[walls]]\ntype = \"plane\"", "2: walls[0].type = 'plane': expected \"half_space\": the shape was "},
      {"[[walls]]\npoint = [0, 1]", "2: walls[0].point = [ 0, 1 ]: expected surface_point: the key was "},
      {"[[walls]]\ntype = \"ball\"\ncentre = [0, 0]\nradius = 0.1\nfilling = \"solid\"",
       "5: walls[0].filling = 'solid': expected inside: the key was renamed\n"},
  });
}

// What would be ignored is a mistake.
TEST_F(a_configuration, says_nothing_that_nobody_reads) {
  const std::string card =
      "law.type = \"no_direct_control\"\n[sensor]\ntype = \"none\"\n[port]\ntype = \"comedi\"\n"
      "amperes_per_volt = 0.1\n";
  const std::string tables = "[brakes]\ntable_1 = [[0, 0], [1, 1]]\n";
  const std::string five_bar = "[mechanism]\ntype = \"five_bar\"\n[homing]\npose = [1.9, 1.2]\n[sensor]\n";
  expect_named({
      {tables + "table_2 = [[0, 0], [1, 1]]\ntorque_per_ampere = 1.5",
       "4: brakes.torque_per_ampere = 1.5: expected no slope if all brakes have a table, "},
      {"[brakes]\ntable_2 = []", "2: brakes.table_2 = []: expected 2 to 16 pairs of amperes"},
      {"[brakes]\nheat = 5", "2: brakes.heat = 5: expected continuous_current, above which "},
      {"[brakes]\nloss_per_kelvin = 0.002",
       "2: brakes.loss_per_kelvin = 0.002: expected 0, as no sensor of this program reads"},
      {five_bar, "5: [sensor] link is missing: expected how far each joint turns the sensor: both angles "},
      {"[mechanism]\ntype = \"xy_table\"\n[sensor]\nlink = [1, 1]",
       "4: sensor.link = [ 1, 1 ]: expected 0, as a slide does not rotate the sensor; remove it"},
      {"[sensor]\ngravity = [0, -9.81]",
       "1: [sensor] handle_mass [kg] = 0: expected > 0 if gravity is given, "},
      {"[sensor]\ntare = false\ntare_tolerance = 0.5",
       "3: sensor.tare_tolerance = 0.5: expected tare = true, without which "},
      {"[sensor]\ntype = \"comedi\"\nrange_of_values = [9, 9, 9, 9, 9, 9]",
       "3: sensor.range_of_values = [ 9, 9, 9, 9, 9, 9 ]: expected 2 numbers, or one for all"},
      {card + "counter_a = 8", "7: port.counter_a = 8: expected counter_setup = \"ni_quadrature\", without"},
      {card + "counter_setup = \"keep\"\ncounter_b = [-1, 9]", "8: port.counter_b = [ -1, 9 ]: expected "},
  });
  for (const std::string& text : {
           tables + "torque_per_ampere = 1.6",
           std::string("[brakes]\nheat = 5\ncontinuous_current = 0.7\nloss_per_kelvin = 0"),
           five_bar + "link = [0, 1]",
           five_bar + "type = \"none\"\n[port]\ntype = \"simulated\"",
           std::string("[mechanism]\ntype = \"xy_table\"\n[sensor]\nlink = 0"),
           std::string("[sensor]\ngravity = [0, 0]\nhandle_mass = 0\ntare = false\nrange_of_values = 9"),
           card + "counter_a = -1",
           card + "counter_setup = \"ni_quadrature\"\ncounter_a = 8\ncounter_b = 9",
           // Keys of a choice that is not made, with what they would be
           std::string(
               "[safety]\nat_release = \"zero\"\nramp_time = 0.5\nhold_time = 10\nsupervisor_priority = 1"),
           card + "[simulation]\npush = 3",
       }) {
    const outcome o =
        check((text.starts_with(five_bar + "type") ? "law.type = \"no_direct_control\"\n" : "") + text);
    EXPECT_EQ(o.status, 0) << text << "\n" << o.err;
  }
}

TEST_F(a_configuration, in_another_unit_or_that_switches_something_off_is_remarked_upon) {
  const outcome o = check(
      "[mechanism]\nlength_1 = 15\n[homing]\npose = [0, 0]\n[[walls]]\nsurface_point = [0, 20]\nstiffness = "
      "10");
  EXPECT_EQ(o.status, 0) << o.err;
  EXPECT_TRUE(
      o.err.starts_with("remark: mechanism: length_1 [m] = 15, usually within 5 m: millimetres?\n"
                        "remark: wall 1: stiffness of a wall [N/m] = 10, usually 100 to 1e9: N/mm?\n"))
      << o.err;
  EXPECT_EQ(check("[brakes]\ntorque_limit = [0, 1]\n[[walls]]\nstiffness = 0").err,
            "remark: brakes: torque_limit[0] [N m] = 0: the brake is off\n"
            "remark: wall 1: stiffness of a wall [N/m] = 0: the wall exerts no force\n");
}

TEST_F(a_configuration, that_is_no_file_is_named) {
  fs::create_directory(directory / "folder");
  ASSERT_EQ(mkfifo((directory / "fifo").c_str(), 0600), 0);
  file("large.toml", "# A comment\n");
  fs::resize_file(directory / "large.toml", 1'000'000'000);  // holes, which take no room
  for (const auto& [path, is] : {std::pair{"none.toml", "no such file"},
                                 {"folder", "is a directory: expected a regular file"},
                                 {"/dev/zero", "is a device: expected a regular file"},
                                 {"fifo", "is a FIFO: expected a regular file"},
                                 {"large.toml", "1000000000 bytes: expected at most 1048576"}}) {
    const outcome o = run({"--config", path, "--check"});
    EXPECT_EQ(o.status, 2) << path;
    EXPECT_EQ(o.err, std::string("error: ") + path + ": " + is + "\n");
  }
  EXPECT_EQ(
      check("version https://git-lfs.github.com/spec/v1\n").err,
      "error: c.toml: a Git LFS pointer, not the file: expected what it points to; run `git lfs pull`\n");
}

// The fuzzer of tests/fuzz/configuration.cpp goes deeper.
TEST_F(a_configuration, that_is_long_or_deep_is_refused_by_its_beginning) {
  const std::string text(100'000, 'x'), begins(100, 'x');
  for (const std::string& line :
       {"law.type = \"" + text + "\"", text + " = 1", "allow_large = [\"" + text + "\"]"}) {
    const outcome o = check(line);
    EXPECT_EQ(o.status, 2);
    EXPECT_LT(o.err.size(), 1000u);
    EXPECT_TRUE(has(o.err, begins)) << o.err;
  }
  std::string dots = "a";
  for (int i = 0; i < 200'000; ++i) dots += ".a";
  for (const std::string& deep : {dots + " = 1", "[[" + dots + "]]"})
    EXPECT_EQ(check(deep).err,
              "error: c.toml:1: over 200 dots in a line: expected fewer; break it into lines\n");
  const outcome o = check("a = " + std::string(200'000, '['));
  EXPECT_EQ(o.status, 2);
  EXPECT_TRUE(o.err.starts_with("error: c.toml:1: Error while parsing ")) << o.err.substr(0, 200);
}

// Of each kind of device, all that bears on how it lets go.
TEST_F(a_configuration, with_any_value_that_is_out_of_all_bounds_is_refused) {
  struct section {
    const char* before;
    std::vector<const char*> keys;
  };
  const section sections[] = {
      {"[brakes]\n",
       {"residual_torque", "torque_per_ampere", "current_limit", "hysteresis", "loss_per_kelvin",
        "continuous_current", "heat", "max_rise_rate"}},
      {"[encoders]\n", {"counts_per_turn", "window", "max_rate", "frozen_travel"}},
      {"[homing]\n", {"duration", "tolerance", "max_gap"}},
      {"[sensor]\n",
       {"x_newtons_per_unit", "y_newtons_per_unit", "handle_mass", "gravity", "tare_tolerance"}},
      {"[sensor]\ntype = \"net_ft\"\n",
       {"port", "counts_per_force", "counts_per_torque", "open_timeout", "silence"}},
      {"[loop]\n", {"period", "max_overruns", "max_sleep", "priority", "cpu"}},
      {"[safety]\n", {"ramp_time", "hold_over", "supervisor_timeout", "supervisor_priority"}},
      {"[sensor]\ntype = \"none\"\n[port]\ntype = \"serial\"\n", {"open_timeout", "baud"}},
      {"[sensor]\ntype = \"none\"\n[port]\ntype = \"comedi\"\n",
       {"amperes_per_volt", "output_channels", "output_ranges", "counter_channels"}},
  };
  for (const auto& [before, keys] : sections)
    for (const char* key : keys)
      for (const char* value : {"-9223372036854775807", "1e300", "nan"}) {
        const std::string line = std::string(key) + " = " + value;
        const outcome o = check("law.type = \"no_direct_control\"\n" + std::string(before) + line);
        EXPECT_EQ(o.status, 2) << before << line << "\n" << o.out << o.err;
        EXPECT_TRUE(o.err.starts_with("error: c.toml:")) << o.err;
      }
  EXPECT_TRUE(
      has(check("[encoders]\nwindow = 17").err, "window [periods] = 17: expected at most the capacity, 16"));
}

TEST_F(a_configuration, has_values_of_no_device_only_if_its_user_says_so) {
  for (const auto& [text, key] :
       {std::pair{"[safety]\nhold_over = 1e12", "hold_over"},
        {"[encoders]\nmax_rate = 1e300", "max_rate"},
        {"[brakes]\ncurrent_limit = 1e9", "current_limit"},
        {"[brakes]\ncurrent_limit = 9\ncontinuous_current = 1e9", "continuous_current"},
        {"[sensor]\nmounting = 90", "mounting"},
        {"[encoders]\ncounts_per_turn = 1e-9", "counts_per_turn"},
        {"[encoders]\nmax_rate = 5e-324", "max_rate"},
        {"[mechanism]\nreduction_2 = 1e9", "reduction_2"},
        {"[mechanism]\nlength_1 = 150\n[homing]\npose = [0, 0]\n[[walls]]\nsurface_point = [0, 99]",
         "length_1"},
        {"[brakes]\ntime_constant = 20", "time_constant"},
        {"[brakes]\ntime_constant = [0.02, 1e-300]", "time_constant"},
        {"[[walls]]\nsurface_point = [0, 1e9]", "surface_point"},
        {"[[walls]]\nstiffness = 1e300", "stiffness"}}) {
    const outcome refused = check(text);
    EXPECT_EQ(refused.status, 2) << key;
    const std::string fix = std::string("; if it is meant, allow_large = [\"") + key + "\"]\n";
    EXPECT_TRUE(refused.err.ends_with(fix)) << refused.err;
    std::string allowed = std::string("allow_large = [\"") + key + "\"";
    // With what follows from it
    if (std::string(key) == "current_limit") allowed += R"(, "continuous_current", "torque_limit")";
    if (std::string(key) == "counts_per_turn") allowed += R"(, "rate_dead_band")";
    const outcome o = check(allowed + "]\n" + text);
    EXPECT_EQ(o.status, 0) << o.err;
  }
  EXPECT_EQ(check("allow_large = [\"hold_over\"]\n[safety]\nhold_over = 1").err,
            "error: c.toml:1: allow_large = [\"hold_over\"]: expected keys of values that no device has; "
            "remove it\n");
  EXPECT_TRUE(has(check("allow_large = true").err, "allow_large = true: expected a list of keys in quotes"));
}

TEST_F(a_configuration, that_the_documentation_writes_down_is_read_key_by_key) {
  // Each key of the documentation renamed is unknown, so each is read
  const std::string all = text_of(shipped + "/simulated.toml");
  std::istringstream lines(all);
  int keys = 0;
  for (std::string line; std::getline(lines, line);) {
    const auto equals = line.find(" = ");
    if (equals == std::string::npos || line.starts_with("#") || line.starts_with(" ")) continue;
    const std::string key = line.substr(0, equals);
    std::string spoilt = all;
    spoilt.replace(spoilt.find("\n" + line) + 1, key.size(), key + "_");
    const outcome o = check(spoilt);
    EXPECT_EQ(o.status, 2) << key;
    EXPECT_TRUE(has(o.err, "unknown key") && has(o.err, key + "_'")) << key << "\n" << o.err;
    ++keys;
  }
  EXPECT_GT(keys, 40);
}

TEST_F(a_configuration, is_not_read_after_a_mistake_in_the_options) {
  for (const auto& [arguments, message] : {
           std::pair{words{"--seconds", "x"}, "--seconds: x: expected a number > 0"},
           {{"--seconds", "0"}, "--seconds: 0: expected a number > 0"},
           {{"--seconds=nan"}, "--seconds: nan: expected a number > 0"},
           {{"--seconds=1s"}, "--seconds: 1s: expected a number > 0"},
           {{"--seconds"}, "--seconds: 1 required NUMBER missing"},
           {{"--config"}, "--config: 1 required FILE missing"},
           {{"--config", ""}, "--config: empty: expected a value"},
           {{"--second=1"}, "The following argument was not expected: --second=1"},
           {{"c.toml"}, "The following argument was not expected: c.toml"},
       }) {
    const outcome o = run(arguments);
    EXPECT_EQ(o.status, 2) << message;
    EXPECT_EQ(o.err, std::string("error: ") + message + "; --help lists the options\n");
  }
}

}  // namespace configuration_tests
