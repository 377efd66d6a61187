#include <log/replay.hpp>
#include <log/replay_program.hpp>

#include <command_line.hpp>
#include <log/decision.hpp>
#include <output_file.hpp>

#include <passive_haptics/control/device_state.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/runtime/device_file/read_device.hpp>

#include <Eigen/LU>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>

namespace example {
namespace {

struct replay_options {
  std::string config, input;
  std::filesystem::path directory = ".";
};

replay_options parse(int argc, char** argv) {
  replay_options chosen;
  command_line line(
      "replay",
      "Reads a log (docs/guide/log.md), runs each line through the control law of a device, and "
      "writes the commands\nto the brakes to replay.csv.");
  line.text("--config", chosen.config, "FILE",
            "the device: the file that brake_driver reads; without it the paper's device under "
            "direct_control");
  line.text("--input", chosen.input, "FILE",
            "the log; without it a short one of the paper's device, made up here");
  line.output(chosen.directory);
  line.parse(argc, argv);
  return chosen;
}

// Half a second along the wall and a little in and out of it.
std::string made_up_log() {
  const ph::tendon_two_link<double> arm;
  log_row row;
  std::string log;
  for (int k = 0; k < 500; ++k) {
    const double t = 1e-3 * k, speed = 0.1, depth = 2e-4 * std::sin(20 * t);
    const auto q = arm.inverse({0.06 + speed * t, 0.225 + depth}, ph::elbow::left).q;
    const ph::vector<double, 2> v(speed, 4e-3 * std::cos(20 * t));
    row.start();
    put_motion(row, {},
               ph::device_state<ph::tendon_two_link<double>>{
                   t, q, arm.jacobian(q).partialPivLu().solve(v), {0.5, 2}});
    if (k == 0) log = row.header();
    log += row.csv();
  }
  return log;
}

// What brake_driver reads besides.
void pass_over_driver(ph::runtime::toml_section& file) {
  for (const char* key : {"log", "encoders", "homing", "port", "loop", "safety", "simulation"})
    file.pass_over(key);
  auto brakes = file.section("brakes");
  for (const char* key : {"residual_torque", "torque_per_ampere", "table_1", "table_2", "current_limit",
                          "hysteresis", "loss_per_kelvin", "continuous_current", "heat", "max_rise_rate"})
    brakes.pass_over(key);
  auto sensor = file.section("sensor");
  std::string type = "simulated";
  sensor.read("type", type, {"simulated", "comedi", "net_ft", "none"});
  sensor.pass_over_others();
}

std::unique_ptr<ph::runtime::any_controller> controller_from(const std::string& config,
                                                             const ph::runtime::catalogue& all) {
  using ph::runtime::toml_section;
  toml_section file = config.empty() ? toml_section::text("built-in device", "law.type = \"direct_control\"")
                                     : toml_section::file(config);
  const auto device = ph::runtime::read_device(file, all);
  pass_over_driver(file);
  file.finish();
  std::cerr << device.remarks;
  return device.make_controller(all, *device.make_mechanism(all));
}

// Lines done, every two seconds.
std::function<void(std::size_t)> progress() {
  return [printed = std::chrono::steady_clock::now()](std::size_t lines) mutable {
    const auto now = std::chrono::steady_clock::now();
    if (now - printed < std::chrono::seconds(2)) return;
    printed = now;
    std::fprintf(stderr, "%zu lines\n", lines);
  };
}

void run(const replay_options& chosen, const ph::runtime::catalogue& all) {
  const auto control = controller_from(chosen.config, all);
  std::ifstream file;
  std::istringstream text(chosen.input.empty() ? made_up_log() : "");
  if (!chosen.input.empty()) {
    file.open(chosen.input, std::ios::binary);
    if (!file) throw std::runtime_error("cannot read '" + chosen.input + "'");
  }
  std::istream& in = chosen.input.empty() ? static_cast<std::istream&>(text) : file;
  log_reader log(in, chosen.input.empty() ? "the log that is made up here" : chosen.input);
  const std::filesystem::path path = chosen.directory / "replay.csv";
  output_file out(path);
  const replay_summary lines = replay(log, out.stream(), *control, progress());
  out.commit();
  std::cout << lines.lines << " lines, " << lines.decided
            << " with a decision: " << std::filesystem::weakly_canonical(path).string() << "\n";
  if (lines.compared > 0)
    std::cout << "capacities as in the log, to the last digit: " << lines.same << " of " << lines.compared
              << "\n";
}

}  // namespace

int replay_program(int argc, char** argv, const ph::runtime::catalogue& all) try {
  run(parse(argc, argv), all);
  return 0;
} catch (const std::invalid_argument& error) {
  std::fprintf(stderr, "error: %s\n", error.what());
  return 2;
} catch (const std::exception& error) {
  std::fprintf(stderr, "error: %s\n", error.what());
  return 1;
}

}  // namespace example
