// An Arm MPS2 with the image AN386, as in QEMU (-M mps2-an386): line and core are those of the board,
// encoders and brakes are simulated. A second line reports the brakes' currents: a frame of `currents`
// whenever they are set, with the time [ms] as its sequence.
//
//   UART 0   serial line
//   UART 1   currents of the brakes
#pragma once

#include <firmware/brake_controller.hpp>
#include <firmware/cortex_m.hpp>
#include <firmware/simulated_axes.hpp>

// Host and board are processes here and may be delayed by seconds; a host considers 1000 missing samples a
// restart
inline constexpr firmware::settings settings{.watchdog = 8000, .period = 10'000};

class cortex_m_board {
 public:
  cortex_m_board() = default;
  void start();  // the lines, the milliseconds, the watchdog

  void set_current(std::size_t brake, std::uint16_t current);
  std::int32_t read_encoder(std::size_t encoder);
  std::uint8_t brake_faults() { return 0; }
  std::uint8_t encoder_faults() { return 0; }
  void send(std::span<const std::uint8_t> bytes);

  bool receive(std::uint8_t& b);
  bool idle() const;  // nothing was received
  void feed_watchdog();

 private:
  firmware::simulated_axes axes_;
  std::uint32_t moved_ = 0;  // when [ms]
};

extern "C" void line_received_handler();
extern "C" void line_sent_handler();
extern "C" void report_sent_handler();
inline constexpr std::array<cortex_m::interrupt, 3> interrupts{
    {{0, line_received_handler}, {1, line_sent_handler}, {3, report_sent_handler}}};
