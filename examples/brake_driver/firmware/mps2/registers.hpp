/// Registers for board.cpp, of the Cortex-M System Design Kit (ARM DDI 0479) in an MPS2 (ARM DAI 0386).
#pragma once

#include <firmware/cortex_m.hpp>

namespace registers {

using cortex_m::at, cortex_m::reg;

struct uart_block {
  reg data, state, ctrl, interrupts, bauddiv;
};
struct watchdog_block {
  reg load, value, ctrl, intclr;
};

inline constexpr std::uint32_t uart_full = 1;                              // of state: no room to send
inline constexpr std::uint32_t uart_sent = 1, uart_received = 2;           // of interrupts; writing 1 clears
inline constexpr std::uint32_t uart_sends = 1 | 4, uart_receives = 2 | 8;  // of ctrl, with their interrupts

inline uart_block& uart_0() { return at<uart_block>(0x4000'4000); }
inline uart_block& uart_1() { return at<uart_block>(0x4000'5000); }
inline watchdog_block& watchdog() { return at<watchdog_block>(0x4000'8000); }

}  // namespace registers
