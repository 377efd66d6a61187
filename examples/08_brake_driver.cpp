// Drives the brakes of a real device, or of a simulated one, at 1 kHz.
#include <session.hpp>

#include <charconv>
#include <iostream>
#include <sstream>
#include <stdexcept>

namespace {

constexpr const char* help = R"(usage: 08_brake_driver [OPTION]...

Reads a device's encoders and force sensor, displays virtual walls with its brakes, and releases them when anything
is wrong. Without options: the paper's device, simulated, for 10 s.

  --config FILE    what the device is and how it is connected (TOML; see examples/brake_driver/*.toml)
  --simulate       a simulated device in place of the one that the file names
  --seconds N      end after so long; otherwise Ctrl-C ends it, which releases the brakes first
  --check          only say whether the configuration is right
  --quiet          no live table
  --help           this text

Signals: SIGINT (Ctrl-C), SIGTERM and SIGHUP release and end; SIGUSR1 rearms after a fault that is over.
Exit status: 0; 1 if the device is not there; 2 for a mistake in the options or the file; 3 if a fault released the brakes,
4 if the log is not whole, 7 for both.
)";

struct arguments {
  std::string config;
  bool simulate = false, check = false;
  example::session_options options;
};

arguments parse(int argc, char** argv) {
  arguments all;
  if (argc == 1) all.options.seconds = 10;
  for (int i = 1; i < argc; ++i) {
    const std::string option = argv[i];
    const auto value = [&]() -> std::string {
      if (i + 1 == argc || *argv[i + 1] == '\0')
        throw std::invalid_argument("a value is missing after '" + option + "'");
      return argv[++i];
    };
    if (option == "--help" || option == "-h") {
      std::cout << help;
      std::exit(0);
    } else if (option == "--config") {
      all.config = value();
    } else if (option == "--simulate") {
      all.simulate = true;
    } else if (option == "--check") {
      all.check = true;
    } else if (option == "--quiet") {
      all.options.live = false;
    } else if (option == "--seconds") {
      const std::string text = value();
      const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), all.options.seconds);
      if (error != std::errc() || end != text.data() + text.size() || !(all.options.seconds > 0))
        throw std::invalid_argument("--seconds " + text + ", expected a number > 0");
    } else {
      throw std::invalid_argument(
          "unknown option '" + option +
          "'; choices: --config FILE, --simulate, --seconds N, --check, --quiet, --help");
    }
  }
  return all;
}

}  // namespace

int main(int argc, char** argv) try {
  const arguments chosen = parse(argc, argv);
  example::configuration c = example::read_configuration(chosen.config);
  if (chosen.simulate) c = example::simulated(c);
  std::istringstream remarks(example::remarks(c));
  for (std::string line; std::getline(remarks, line);) std::cerr << "remark: " << line << "\n";
  if (chosen.check) {
    std::cout << (chosen.config.empty() ? "the built-in configuration" : chosen.config)
              << " is right: " << c.mechanism << ", " << c.port << " device, " << c.sensor
              << " force sensor, " << c.law << "\n";
    return 0;
  }
  return example::run_session(c, chosen.options);
} catch (const std::invalid_argument& error) {
  std::cerr << "error: " << error.what() << "\n";
  return 2;
} catch (const std::exception& error) {
  std::cerr << "error: " << error.what() << "\n";
  return 1;
}
