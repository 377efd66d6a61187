#include <log/replay.hpp>
#include <log/replay_program.hpp>

#include <command_line.hpp>
#include <driver_keys.hpp>
#include <log/decision.hpp>
#include <log/device_name.hpp>
#include <output_file.hpp>

#include <passive_haptics/control/device_state.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/runtime/device_file/read_device.hpp>
#include <passive_haptics/scene/files/file_kind.hpp>

#include <Eigen/LU>

#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>

namespace example {
namespace {

struct replay_options {
  std::string log, config;
  std::filesystem::path directory = ".";
};

replay_options parse(int argc, char** argv) {
  replay_options chosen;
  command_line line(
      "replay",
      "Runs each line of a log (docs/guide/log.md) through the control law of its device, writes the\n"
      "decisions to replay.csv, and prints how many capacities are equal to those of the log, bit by bit.");
  line.text("LOG", chosen.log, "", "default: a short log of the paper's device under direct_control");
  line.text(
      "--config", chosen.config, "FILE",
      "the device (docs/guide/device.md); default: LOG.device.toml, written by brake_driver next to LOG.csv");
  line.output(chosen.directory);
  line.notes(
      "Exit status: 0; 1 if a file cannot be read or written; 2 for an error in the options or the device "
      "file.");
  line.parse(argc, argv);
  return chosen;
}

// Half a second of motion along the wall, slightly in and out of it.
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

// Name of the device file; empty for the built-in device.
std::string device_file(const replay_options& chosen) {
  if (!chosen.config.empty() || chosen.log.empty()) return chosen.config;
  const std::string name = device_name(chosen.log);
  if (ph::file_kind(name) == "nothing")
    throw std::invalid_argument(name +
                                ": no such file: expected the device file that brake_driver wrote next to " +
                                chosen.log + "; give the device of the log by --config FILE");
  return name;
}

std::unique_ptr<ph::runtime::any_controller> controller_from(const std::string& name,
                                                             const ph::runtime::catalogue& all) {
  using ph::runtime::toml_section;
  toml_section file = name.empty() ? toml_section::text("built-in device", "law.type = \"direct_control\"")
                                   : toml_section::file(name);
  const auto device = ph::runtime::read_device(file, all);
  finish_without_driver(file);
  std::cerr << device.remarks;
  return device.make_controller(all, *device.make_mechanism(all));
}

// Prints the number of lines every two seconds.
std::function<void(std::size_t)> progress() {
  return [printed = std::chrono::steady_clock::now()](std::size_t lines) mutable {
    const auto now = std::chrono::steady_clock::now();
    if (now - printed < std::chrono::seconds(2)) return;
    printed = now;
    std::fprintf(stderr, "%zu lines\n", lines);
  };
}

void run(const replay_options& chosen, const ph::runtime::catalogue& all) {
  std::ifstream file;
  std::istringstream text(chosen.log.empty() ? made_up_log() : "");
  if (!chosen.log.empty()) {
    file.open(chosen.log, std::ios::binary);
    if (!file) throw std::runtime_error("cannot read '" + chosen.log + "': " + std::strerror(errno));
  }
  const std::string device = device_file(chosen);
  const auto control = controller_from(device, all);
  std::istream& in = chosen.log.empty() ? static_cast<std::istream&>(text) : file;
  log_reader log(in, chosen.log.empty() ? "the built-in log" : chosen.log);
  const std::filesystem::path path = chosen.directory / "replay.csv";
  output_file out(path);
  const replay_summary lines = replay(log, out.stream(), *control, progress());
  out.commit();
  std::cout << "device: " << (device.empty() ? "the paper's under direct_control" : device) << "\n"
            << lines.lines << " lines, " << lines.decided
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
