/// Common to all Cortex-M cores: milliseconds, interrupts, sleep (ARMv7-M Architecture Reference Manual).
#pragma once

#include <atomic>
#include <cstdint>

namespace cortex_m {

using reg = volatile std::uint32_t;

template <class Block>
Block& at(std::uintptr_t address) {
  return *reinterpret_cast<Block*>(address);
}

struct systick_block {
  reg ctrl, load, val;
};
struct nvic_block {
  reg iser[8], reserved_1[24], icer[8], reserved_2[24], ispr[8];
};

inline systick_block& systick() { return at<systick_block>(0xE000'E010); }
inline nvic_block& nvic() { return at<nvic_block>(0xE000'E100); }

inline void enable_interrupt(int line) { nvic().iser[line / 32] = 1u << line % 32; }
/// Sets the interrupt pending.
inline void raise_interrupt(int line) { nvic().ispr[line / 32] = 1u << line % 32; }

/// Since start_milliseconds(), modulo 2^32.
inline constinit std::atomic<std::uint32_t> milliseconds{0};

/// clock: core clock [Hz].
inline void start_milliseconds(std::uint32_t clock) {
  systick().load = clock / 1000 - 1;
  systick().val = 0;
  systick().ctrl = 7;
}

/// Sleeps until an interrupt unless idle() is false; an interrupt in between still wakes it.
template <class Idle>
void sleep_if(Idle&& idle) {
  asm volatile("cpsid i" ::: "memory");
  if (idle()) asm volatile("wfi" ::: "memory");
  asm volatile("cpsie i" ::: "memory");
}

/// A handler and its interrupt line.
struct interrupt {
  int line;
  void (*handler)();
};

}  // namespace cortex_m

extern "C" void systick_handler();
