#include "your_port.hpp"

#include <passive_haptics/driver/control_loop.hpp>
#include <passive_haptics/driver/process/standard_descriptors.hpp>
#include <passive_haptics/driver/process/supervisor.hpp>
#include <passive_haptics/driver/safe_port.hpp>
#include <passive_haptics/driver/thread/threaded_port.hpp>

#include <cmath>
#include <iostream>
#include <thread>

// Instead of the board: sends a sample for all currents, until stop(). `last` are the currents of its brakes.
struct stand_in {
  int listening = socket(AF_INET, SOCK_DGRAM, 0);
  sockaddr_in at{AF_INET, 0, {htonl(INADDR_LOOPBACK)}, {}};
  std::atomic<float> last = -1;

  stand_in() {
    socklen_t size = sizeof at;
    bind(listening, reinterpret_cast<sockaddr*>(&at), size);
    getsockname(listening, reinterpret_cast<sockaddr*>(&at), &size);
  }
  std::uint16_t port() const { return ntohs(at.sin_port); }
  void stop() { sendto(listening, nullptr, 0, 0, reinterpret_cast<sockaddr*>(&at), sizeof at); }
  void answer() {
    board_sample sample{};
    float amperes[2];
    sockaddr_in from{};
    socklen_t size = sizeof from;
    while (recvfrom(listening, amperes, sizeof amperes, 0, reinterpret_cast<sockaddr*>(&from), &size) ==
           sizeof amperes) {
      last = amperes[0];
      ++sample.sequence;
      sample.time = static_cast<std::uint32_t>(std::llround(1e6 * ph::monotonic_seconds()));
      sendto(listening, &sample, sizeof sample, 0, reinterpret_cast<sockaddr*>(&from), size);
    }
  }
};

int main() {
  if (!ph::open_standard_descriptors()) return 1;  // otherwise output may go to a socket
  stand_in board;

  ph::supervisor<udp_board> guard(udp_board(board.port()), {.timeout = 1});
  ph::safe_port<ph::threaded_port<udp_board>> port(ph::threaded_port(udp_board(board.port())), {},
                                                   {.hold_over = 1});
  std::string error = guard.start();  // first: it forks
  std::thread answers([&] { board.answer(); });
  if (error.empty()) error = port.open();
  std::cout << (error.empty() ? "open" : error) << "\n";

  ph::control_loop loop;
  float held = 0;
  loop.run(
      [&](const ph::loop_cycle& now) {
        port.read(now.time);
        port.activate();  // a real program homes before
        if (!guard.beat(now.time, port.applied())) port.release({ph::fault::supervisor_lost}, guard.began());
        port.write({0.25, 0.25});
        held = std::max(held, board.last.load());
        return now.number < 2000 && held < 0.25f;
      },
      [] { return false; }, [&](ph::fault why) { port.release({why}); });
  guard.stop();
  while (board.last != 0) std::this_thread::yield();
  std::cout << "held with " << held << " A, released with " << board.last
            << " A: " << to_string(port.reason()) << "\n";

  board.stop();
  answers.join();
  return held == 0.25f ? 0 : 1;
}
