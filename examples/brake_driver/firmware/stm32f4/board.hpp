// STM32F405/407: a template, written by its reference manual and compiled in the tests, but never run on
// hardware. Adapt set_up_pins() and cortex_m_board to your board.
//
//   PA0, PA1 and PA15, PB3   encoders A, B (timers 5 and 2, 32 bits, four counts a line)
//   PA2, PA3                 serial line, 1 Mbit/s (USART 2)
//   PA6, PA7                 PWM, 20 kHz, 0 % = 0 A to current amplifiers; each needs a pull-down, for the
//                            time of a reset
//   PC0, PC1 and PC2, PC3    fault outputs of amplifiers and of encoder receivers, low = fault
#pragma once

#include <firmware/brake_controller.hpp>
#include <firmware/cortex_m.hpp>

inline constexpr firmware::settings settings{};  // two encoders, two brakes

class cortex_m_board {
 public:
  cortex_m_board();  // the brakes at 0 A
  void start();      // the line, the milliseconds, the watchdog

  void set_current(std::size_t brake, std::uint16_t current);
  std::int32_t read_encoder(std::size_t encoder);
  std::uint8_t brake_faults();
  std::uint8_t encoder_faults();
  void send(std::span<const std::uint8_t> bytes);

  bool receive(std::uint8_t& b);
  bool idle() const;  // nothing was received
  void feed_watchdog();
};

extern "C" void usart_2_handler();
inline constexpr std::array<cortex_m::interrupt, 1> interrupts{{{38, usart_2_handler}}};
