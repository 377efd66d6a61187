#include <board.hpp>
#include <firmware/byte_queue.hpp>
#include <registers.hpp>

namespace {

namespace serial = example::serial;
using namespace registers;

constexpr std::uint32_t clock = 25'000'000;  // core and peripherals [Hz]
constexpr std::uint32_t baud = 1'000'000;

constinit firmware::byte_queue<256> received, to_send;
constinit firmware::byte_queue<4096> to_report;

// Sends the next byte if the last one is out.
template <std::uint32_t Size>
void send_next(uart_block& uart, firmware::byte_queue<Size>& from) {
  uart.interrupts = uart_sent;
  if (std::uint8_t b; (uart.state & uart_full) == 0 && from.pop(b)) uart.data = b;
}

// Queues all bytes or none; the interrupt sends them.
template <std::uint32_t Size>
void queue(std::span<const std::uint8_t> bytes, firmware::byte_queue<Size>& to, int line) {
  if (to.room() < bytes.size()) return;
  for (const std::uint8_t b : bytes) to.push(b);
  cortex_m::raise_interrupt(line);
}

void set_up_lines() {
  for (uart_block* uart : {&uart_0(), &uart_1()}) uart->bauddiv = clock / baud;
  uart_0().ctrl = uart_sends | uart_receives;
  uart_1().ctrl = uart_sends;
  for (const auto& one : interrupts) cortex_m::enable_interrupt(one.line);
}

// Resets everything if the loop does not run for 2 s: a warning after 1 s, then the reset. Emulated time
// jumps if the emulator gets no processor.
void set_up_watchdog() {
  watchdog().load = clock;
  watchdog().ctrl = 3;
}

}  // namespace

void cortex_m_board::start() {
  set_up_lines();
  cortex_m::start_milliseconds(clock);
  set_up_watchdog();
}

void cortex_m_board::set_current(std::size_t brake, std::uint16_t current) {
  axes_.set_current(brake, current);
  if (brake + 1 < settings.brakes) return;
  serial::currents all{settings.brakes, {}};
  for (std::size_t i = 0; i < settings.brakes; ++i) all.current[i] = axes_.current(i);
  queue(serial::encode(serial::pack(cortex_m::milliseconds.load(), all)).content(), to_report,
        interrupts[2].line);
}

std::int32_t cortex_m_board::read_encoder(std::size_t encoder) {
  const std::uint32_t now = cortex_m::milliseconds.load();
  axes_.advance(1e-3 * (now - moved_));
  moved_ = now;
  return axes_.read_encoder(encoder);
}

void cortex_m_board::send(std::span<const std::uint8_t> bytes) { queue(bytes, to_send, interrupts[1].line); }

bool cortex_m_board::receive(std::uint8_t& b) { return received.pop(b); }
bool cortex_m_board::idle() const { return received.empty(); }
void cortex_m_board::feed_watchdog() { watchdog().intclr = 1; }

extern "C" void line_received_handler() {
  uart_0().interrupts = uart_received;
  const auto b = static_cast<std::uint8_t>(uart_0().data);
  if (received.room() > 0) received.push(b);
}
extern "C" void line_sent_handler() { send_next(uart_0(), to_send); }
extern "C" void report_sent_handler() { send_next(uart_1(), to_report); }
