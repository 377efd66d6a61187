#include <board.hpp>
#include <firmware/byte_queue.hpp>
#include <registers.hpp>

namespace {

using namespace registers;

constexpr std::uint32_t full_scale = 10'000;         // current at 100 % [serial::current_unit]: 1 A
constexpr std::uint32_t clock = 84'000'000;          // of core and timers [Hz]
constexpr std::uint32_t pwm_steps = clock / 20'000;  // a period
constexpr std::uint32_t line_clock = clock / 2, baud = 1'000'000;
static_assert(line_clock % baud == 0);

constinit firmware::byte_queue<256> received, to_send;

void set_up_clocks() {
  rcc().cr = rcc().cr | 1u << 16;  // 8 MHz quartz, the accuracy of the samples' times
  while ((rcc().cr & 1u << 17) == 0) {
  }
  flash().acr = 1u << 10 | 1u << 9 | 1u << 8 | 2;                  // caches, prefetch, two wait states
  rcc().pllcfgr = 1u << 22 | 7u << 24 | 1u << 16 | 336u << 6 | 8;  // 8 MHz / 8 x 336 / 4
  rcc().cr = rcc().cr | 1u << 24;
  while ((rcc().cr & 1u << 25) == 0) {
  }
  rcc().cfgr = 4u << 10 | 2;  // serial line at half the clock, timers at the full clock
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
  timer_3().ccmr1 = 0x6868;  // PWM mode 1, new values apply from the next period
  timer_3().ccer = 1u | 1u << 4;
  timer_3().egr = 1;
  timer_3().cr1 = 1u | 1u << 7;
}

// Last, so that no pin drives anything before its timer outputs 0 A.
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
  cortex_m::enable_interrupt(interrupts[0].line);
}

// Resets everything, which releases the brakes, if the loop does not run for 12 ms (9 to 24, its clock is
// inaccurate).
void set_up_watchdog() {
  watchdog().kr = 0xCCCC;  // starts it and its clock, without which the next writes have no effect
  watchdog().kr = 0x5555;
  watchdog().rlr = 100;
  while (watchdog().sr != 0) {
  }
}

}  // namespace

cortex_m_board::cortex_m_board() {
  set_up_clocks();
  set_up_encoder(timer_5());
  set_up_encoder(timer_2());
  set_up_brakes();
  set_up_pins();
}

void cortex_m_board::start() {
  set_up_serial_line();
  cortex_m::start_milliseconds(clock);
  set_up_watchdog();
}

void cortex_m_board::set_current(std::size_t brake, std::uint16_t current) {
  timer_3().ccr[brake] = current * pwm_steps / full_scale;
}

std::int32_t cortex_m_board::read_encoder(std::size_t encoder) {
  return static_cast<std::int32_t>((encoder == 0 ? timer_5() : timer_2()).cnt);
}

std::uint8_t cortex_m_board::brake_faults() { return static_cast<std::uint8_t>(~gpio_c().idr & 3u); }
std::uint8_t cortex_m_board::encoder_faults() { return static_cast<std::uint8_t>((~gpio_c().idr >> 2) & 3u); }

void cortex_m_board::send(std::span<const std::uint8_t> bytes) {
  if (to_send.room() < bytes.size()) return;
  for (const std::uint8_t b : bytes) to_send.push(b);
  usart_2().cr1 = usart_2().cr1 | 1u << 7;  // interrupt when there is room
}

bool cortex_m_board::receive(std::uint8_t& b) { return received.pop(b); }
bool cortex_m_board::idle() const { return received.empty(); }
void cortex_m_board::feed_watchdog() { watchdog().kr = 0xAAAA; }

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
