// The firmware as a process: a device on a pseudo-terminal, to try the driver and to test it.
//
//   brake_firmware_host [--encoders N] [--brakes N] [--link FILE]
//
// Prints the file that a host opens, also reached as FILE, and runs until SIGINT or SIGTERM.
#include <firmware/brake_controller.hpp>
#include <firmware/host_board.hpp>

#include <passive_haptics/driver/clock.hpp>

#include <csignal>
#include <cstdio>
#include <cstring>
#include <string_view>

namespace {

volatile std::sig_atomic_t ended = 0;
void end(int) { ended = 1; }

int usage() {
  std::fprintf(stderr, "usage: brake_firmware_host [--encoders 1..8] [--brakes 1..8] [--link FILE]\n");
  return 2;
}

void run(firmware::pseudo_terminal& line, const firmware::settings& settings) {
  firmware::host_board board(line);
  firmware::brake_controller controller(board, settings);
  const passive_haptics::monotonic_clock clock;
  const std::int64_t start = clock.now(), period = std::int64_t{1000} * settings.period;
  std::array<std::uint8_t, 512> bytes;
  for (std::int64_t next = start + period; ended == 0; next += period) {
    clock.sleep_until(next);
    const auto now = static_cast<std::uint32_t>((clock.now() - start) / 1000);
    for (std::size_t n; (n = line.read(bytes)) > 0;)
      for (const std::uint8_t b : std::span(bytes).first(n)) controller.receive(b, now);
    board.advance(1e-9 * static_cast<double>(period));
    controller.tick(now);
  }
}

}  // namespace

int main(int argc, char** argv) {
  firmware::settings settings;
  const char* link = nullptr;
  for (int i = 1; i < argc; i += 2) {
    const std::string_view name = argv[i];
    if (i + 1 == argc) return usage();
    const int n = std::atoi(argv[i + 1]);
    const bool count = n >= 1 && n <= int{example::serial::most_channels};
    if (name == "--encoders" && count) settings.encoders = static_cast<std::uint8_t>(n);
    else if (name == "--brakes" && count) settings.brakes = static_cast<std::uint8_t>(n);
    else if (name == "--link") link = argv[i + 1];
    else return usage();
  }
  firmware::pseudo_terminal line;
  if (line.path().empty()) return std::perror("no pseudo-terminal"), 1;
  if (link != nullptr && symlink(line.path().c_str(), link) != 0) return std::perror(link), 1;
  std::signal(SIGINT, end);
  std::signal(SIGTERM, end);
  std::printf("%s\n", line.path().c_str());
  std::fflush(stdout);
  run(line, settings);
  if (link != nullptr) unlink(link);
}
