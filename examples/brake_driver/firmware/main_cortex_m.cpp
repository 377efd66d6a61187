// The firmware on a board: a template, written against the reference manual of the STM32F405/407 and compiled
// in the tests, but never run on one. What a board has elsewhere is in set_up_pins() and cortex_m_board.
//
//   PA0, PA1 and PA15, PB3   encoders A, B (timers 5 and 2, 32 bits, four counts a line)
//   PA2, PA3                 serial line, 1 Mbit/s (USART 2)
//   PA6, PA7                 PWM, 20 kHz, 0 % = 0 A to current amplifiers; each needs a pull-down, for the
//   time of a reset PC0, PC1 and PC2, PC3    fault outputs of amplifiers and of encoder receivers, low =
//   fault
#include <firmware/brake_controller.hpp>
#include <firmware/registers.hpp>

#include <atomic>

namespace {

using namespace registers;

constexpr firmware::settings settings{};             // two encoders, two brakes
constexpr std::uint32_t full_scale = 10'000;         // current at 100 % [serial::current_unit]: 1 A
constexpr std::uint32_t clock = 84'000'000;          // of core and timers [Hz]
constexpr std::uint32_t pwm_steps = clock / 20'000;  // a period
constexpr std::uint32_t line_clock = clock / 2, baud = 1'000'000;
static_assert(line_clock % baud == 0);

// From interrupt to loop or back, without a lock: one side writes, one reads.
template <std::uint32_t Size>
class queue {
 public:
  std::uint32_t room() const {
    return Size - (in_.load(std::memory_order_relaxed) - out_.load(std::memory_order_acquire));
  }
  void push(std::uint8_t b) {
    const std::uint32_t in = in_.load(std::memory_order_relaxed);
    bytes_[in % Size] = b;
    in_.store(in + 1, std::memory_order_release);
  }
  bool pop(std::uint8_t& b) {
    const std::uint32_t out = out_.load(std::memory_order_relaxed);
    if (in_.load(std::memory_order_acquire) == out) return false;
    b = bytes_[out % Size];
    out_.store(out + 1, std::memory_order_release);
    return true;
  }

 private:
  static_assert((Size & (Size - 1)) == 0, "so that the counters may wrap");
  std::array<std::uint8_t, Size> bytes_{};
  std::atomic<std::uint32_t> in_{0}, out_{0};
};

constinit queue<256> received, to_send;
constinit std::atomic<std::uint32_t> milliseconds{0};

struct cortex_m_board {
  void set_current(std::size_t brake, std::uint16_t current) {
    timer_3().ccr[brake] = current * pwm_steps / full_scale;
  }
  std::int32_t read_encoder(std::size_t encoder) {
    return static_cast<std::int32_t>((encoder == 0 ? timer_5() : timer_2()).cnt);
  }
  std::uint8_t brake_faults() { return static_cast<std::uint8_t>(~gpio_c().idr & 3u); }
  std::uint8_t encoder_faults() { return static_cast<std::uint8_t>((~gpio_c().idr >> 2) & 3u); }
  void send(std::span<const std::uint8_t> bytes) {
    if (to_send.room() < bytes.size()) return;
    for (const std::uint8_t b : bytes) to_send.push(b);
    usart_2().cr1 = usart_2().cr1 | 1u << 7;  // interrupt when there is room
  }
};

void set_up_clocks() {
  rcc().cr = rcc().cr | 1u << 16;  // quartz of 8 MHz; the samples' time is as good as it
  while ((rcc().cr & 1u << 17) == 0) {
  }
  flash().acr = 1u << 10 | 1u << 9 | 1u << 8 | 2;                  // caches, prefetch, two wait states
  rcc().pllcfgr = 1u << 22 | 7u << 24 | 1u << 16 | 336u << 6 | 8;  // 8 MHz / 8 x 336 / 4
  rcc().cr = rcc().cr | 1u << 24;
  while ((rcc().cr & 1u << 25) == 0) {
  }
  rcc().cfgr = 4u << 10 | 2;  // the serial line at half the clock, timers at all of it
  while ((rcc().cfgr & 0xCu) != 8u) {
  }
  rcc().ahb1enr = 7;                                  // ports A, B, C
  rcc().apb1enr = 1u | 1u << 1 | 1u << 3 | 1u << 17;  // timers 2, 3, 5, USART 2
}

void set_up_encoder(timer_block& t) {
  t.ccmr1 = 0x3131;  // both inputs, eight equal samples to count as one level
  t.smcr = 3;        // count all edges of both
  t.arr = 0xFFFF'FFFF;
  t.cr1 = 1;
}

void set_up_brakes() {
  timer_3().arr = pwm_steps - 1;
  timer_3().ccr[0] = 0;
  timer_3().ccr[1] = 0;
  timer_3().ccmr1 = 0x6868;  // PWM mode 1, a new value counts from the next period
  timer_3().ccer = 1u | 1u << 4;
  timer_3().egr = 1;
  timer_3().cr1 = 1u | 1u << 7;
}

// Last, so that no pin drives anything before its timer says 0 A.
void set_up_pins() {
  gpio_a().afr[0] = 2u | 2u << 4 | 7u << 8 | 7u << 12 | 2u << 24 | 2u << 28;
  gpio_a().afr[1] = 1u << 28;
  gpio_a().moder = 2u | 2u << 2 | 2u << 4 | 2u << 6 | 2u << 12 | 2u << 14 | 2u << 26 | 2u << 28 | 2u << 30;
  gpio_b().afr[0] = 1u << 12;
  gpio_b().moder = (gpio_b().moder & ~(3u << 6)) | 2u << 6;
  gpio_c().pupdr = 0x55;  // PC0 to PC3 pulled up; a fault pulls down
}

void set_up_serial_line() {
  usart_2().brr = line_clock / baud;
  usart_2().cr1 = 1u << 13 | 1u << 5 | 1u << 3 | 1u << 2;  // on, interrupt for each byte, send and receive
  nvic().iser[usart_2_interrupt / 32] = 1u << usart_2_interrupt % 32;
}

void set_up_tick() {
  systick().load = clock / 1000 - 1;
  systick().val = 0;
  systick().ctrl = 7;
}

// Resets all, and so lets go of the brakes, when the loop does not come round for 12 ms (9 to 24, its clock
// is rough).
void set_up_watchdog() {
  watchdog().kr = 0xCCCC;  // starts it and its clock, without which the next writes never arrive
  watchdog().kr = 0x5555;
  watchdog().rlr = 100;
  while (watchdog().sr != 0) {
  }
}
void feed_watchdog() { watchdog().kr = 0xAAAA; }

}  // namespace

extern "C" void systick_handler() {
  milliseconds.store(milliseconds.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
}

extern "C" void usart_2_handler() {
  const std::uint32_t status = usart_2().sr;
  if ((status & (1u << 5 | 1u << 3)) != 0) {  // a byte, or one was lost: reading clears both
    const auto b = static_cast<std::uint8_t>(usart_2().dr);
    if (received.room() > 0) received.push(b);
  }
  if ((status & 1u << 7) != 0 && (usart_2().cr1 & 1u << 7) != 0) {
    std::uint8_t b;
    if (to_send.pop(b)) usart_2().dr = b;
    else usart_2().cr1 = usart_2().cr1 & ~(1u << 7);
  }
}

int main() {
  set_up_clocks();
  set_up_encoder(timer_5());
  set_up_encoder(timer_2());
  set_up_brakes();
  set_up_pins();
  cortex_m_board board;
  firmware::brake_controller controller(board, settings);
  set_up_serial_line();
  set_up_tick();
  set_up_watchdog();
  for (std::uint32_t last = 0;;) {
    const std::uint32_t now = milliseconds.load(std::memory_order_relaxed);
    for (std::uint8_t b; received.pop(b);) controller.receive(b, 1000 * now);
    if (now == last) continue;
    last = now;
    controller.tick(1000 * now);
    feed_watchdog();
  }
}
