#include <driver_program.hpp>

#include <command_line.hpp>
#include <configuration/home.hpp>
#include <report/limits.hpp>
#include <session.hpp>

#include <cmath>
#include <filesystem>
#include <iostream>
#include <sstream>
#include <stdexcept>

namespace example {
namespace {

struct arguments {
  std::string config;
  bool simulate = false, check = false, limits = false;
  std::filesystem::path directory = ".";
  session_options options;
};

arguments parse(int argc, char** argv) {
  arguments all;
  bool quiet = false;
  command_line line(
      "brake_driver",
      "Reads a device's encoders and force sensor, displays virtual walls with its brakes, and releases "
      "them\n"
      "after any fault. Without --config: the paper's device, simulated, for 10 s.");
  line.text("--config", all.config, "FILE",
            "the device (docs/guide/device.md) and its connection (examples/brake_driver/*.toml)");
  line.flag("--simulate", all.simulate, "use a simulated device instead of the one in the file");
  line.positive("--seconds", all.options.seconds,
                "stop after this time; Ctrl-C releases the brakes and stops earlier");
  line.flag("--check", all.check, "only check the configuration and print the home position");
  line.flag("--limits", all.limits, "only print the limits of the first wall (docs/guide/design.md)");
  line.flag("--quiet", quiet, "no live table");
  line.port("--live", all.options.live_port,
            "send the log to this local UDP port as JSON (docs/guide/log.md)");
  line.output(all.directory);
  line.notes(
      "The device file is written next to the log; `replay LOG` repeats its decisions (docs/guide/log.md).\n"
      "Signals: SIGINT (Ctrl-C), SIGTERM and SIGHUP release the brakes and stop; SIGUSR1 rearms after a "
      "fault,\n"
      "if it arrives after the release.\n"
      "Exit status: 0; 1 if the device cannot be opened; 2 for an error in the options or the file;\n"
      "3 if a fault released the brakes, rearmed or not; 4 if the log is incomplete; 7 for both.");
  line.parse(argc, argv);
  all.options.live = !quiet;
  if (all.config.empty() && std::isinf(all.options.seconds)) all.options.seconds = 10;
  return all;
}

}  // namespace

int driver_program(int argc, char** argv) try {
  const arguments chosen = parse(argc, argv);
  configuration c = read_configuration(chosen.config);
  if (chosen.simulate) c = simulated(c);
  if (!c.log.empty()) c.log = (chosen.directory / c.log).lexically_normal().string();
  std::istringstream unusual(remarks(c));
  for (std::string line; std::getline(unusual, line);) std::cerr << "remark: " << line << "\n";
  if (chosen.check) {
    std::cout << (chosen.config.empty() ? "the built-in configuration" : chosen.config)
              << " is valid: " << summary(c) << "\n"
              << home_in_words(c);
    return 0;
  }
  if (chosen.limits) {
    print_limits(c);
    return 0;
  }
  return run_session(c, chosen.options);
} catch (const std::invalid_argument& error) {
  std::cerr << "error: " << error.what() << "\n";
  return 2;
} catch (const std::exception& error) {
  std::cerr << "error: " << error.what() << "\n";
  return 1;
}

}  // namespace example
