// The firmware on a Cortex-M. A board's directory, given to the compiler by -I, contains board.hpp and
// board.cpp.
#include <board.hpp>
#include <firmware/brake_controller.hpp>
#include <firmware/cortex_m.hpp>

extern "C" void systick_handler() {
  using cortex_m::milliseconds;
  milliseconds.store(milliseconds.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
}

int main() {
  cortex_m_board board;
  firmware::brake_controller controller(board, settings);
  board.start();
  for (std::uint32_t last = 0;;) {
    const std::uint32_t now = 1000 * cortex_m::milliseconds.load(std::memory_order_relaxed);  // [us]
    for (std::uint8_t b; board.receive(b);) controller.receive(b, now);
    if (now - last < settings.period) {
      cortex_m::sleep_if([&] { return board.idle() && 1000 * cortex_m::milliseconds.load() == now; });
      continue;
    }
    last = now;
    controller.tick(now);
    board.feed_watchdog();
  }
}
