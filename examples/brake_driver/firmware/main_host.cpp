// The firmware as a process: a device on a pseudo-terminal, for trying and testing the driver.
//
//   brake_firmware_host [--encoders N] [--brakes N] [--watchdog MS] [--period US] [--link FILE]
//
// Prints the file for the host, also linked as FILE, and runs until SIGINT or SIGTERM.
#include <firmware/brake_controller.hpp>
#include <firmware/host_board.hpp>

#include <passive_haptics/driver/clock.hpp>
#include <passive_haptics/driver/process/standard_descriptors.hpp>

#include <csignal>
#include <cstdio>
#include <cstring>
#include <string_view>

namespace {

volatile std::sig_atomic_t ended = 0;
void end(int) { ended = 1; }

int usage() {
  std::fprintf(stderr,
               "usage: brake_firmware_host [--encoders 1..8] [--brakes 1..8] [--watchdog 2..60000] [--period "
               "100..60000] "
               "[--link FILE]\n");
  return 2;
}

void run(firmware::pseudo_terminal& line, const firmware::settings& settings) {
  firmware::host_board board(line);
  firmware::brake_controller controller(board, settings);
  const passive_haptics::monotonic_clock clock;
  const std::int64_t start = clock.now(), period = std::int64_t{1000} * settings.period;
  std::array<std::uint8_t, 8192> bytes;
  for (std::int64_t next = start + period; ended == 0;) {
    clock.sleep_until(next);
    // A process may be delayed, unlike a microcontroller: it executes each missed period, and distributes the
    // received bytes evenly.
    const auto periods = static_cast<std::size_t>(1 + (clock.now() - next) / period);
    const std::size_t all = line.read(bytes);
    for (std::size_t i = 0; i < periods; ++i, next += period) {
      const auto now = static_cast<std::uint32_t>((next - start) / 1000);
      const std::size_t from = all * i / periods, to = all * (i + 1) / periods;
      for (const std::uint8_t b : std::span(bytes).subspan(from, to - from)) controller.receive(b, now);
      board.advance(1e-9 * static_cast<double>(period));
      controller.tick(now);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (!passive_haptics::open_standard_descriptors()) return std::perror("/dev/null"), 1;
  firmware::settings settings;
  const char* link = nullptr;
  for (int i = 1; i < argc; i += 2) {
    const std::string_view name = argv[i];
    if (i + 1 == argc) return usage();
    const int n = std::atoi(argv[i + 1]);
    const bool count = n >= 1 && n <= int{example::serial::max_channels};
    if (name == "--encoders" && count) settings.encoders = static_cast<std::uint8_t>(n);
    else if (name == "--brakes" && count) settings.brakes = static_cast<std::uint8_t>(n);
    else if (name == "--watchdog" && n >= 2 && n <= 60'000) settings.watchdog = static_cast<std::uint16_t>(n);
    else if (name == "--period" && n >= 100 && n <= 60'000) settings.period = static_cast<std::uint16_t>(n);
    else if (name == "--link") link = argv[i + 1];
    else return usage();
  }
  firmware::pseudo_terminal line;
  if (line.path().empty()) return std::perror("no pseudo-terminal"), 1;
  if (link != nullptr && symlink(line.path().c_str(), link) != 0) return std::perror(link), 1;
  std::signal(SIGINT, end);
  std::signal(SIGTERM, end);
  std::signal(SIGPIPE, SIG_IGN);  // stdout may be a pipe without a reader
  std::printf("%s\n", line.path().c_str());
  std::fflush(stdout);
  run(line, settings);
  if (link != nullptr) unlink(link);
}
