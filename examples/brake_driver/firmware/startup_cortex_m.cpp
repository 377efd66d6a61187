// From reset to main(): the vector table, memory as C++ expects it. Goes with cortex_m.ld.
#include <cstdint>

extern "C" {
extern std::uint32_t stack_top, data_source, data_begin, data_end, bss_begin, bss_end;

int main();
void systick_handler();
void usart_2_handler();

[[noreturn]] void reset_handler() {
  const std::uint32_t* from = &data_source;
  for (std::uint32_t* to = &data_begin; to < &data_end;) *to++ = *from++;
  for (std::uint32_t* to = &bss_begin; to < &bss_end;) *to++ = 0;
  main();
  for (;;) {
  }
}

// Any fault or unexpected interrupt: stand still until the watchdog resets all.
[[noreturn]] void stop_handler() {
  for (;;) {
  }
}
}

namespace {

using handler = void (*)();
struct vectors {
  std::uint32_t* stack = &stack_top;
  handler reset = reset_handler;
  handler faults[9] = {stop_handler, stop_handler, stop_handler, stop_handler, stop_handler};
  handler calls[4] = {stop_handler, stop_handler, nullptr, stop_handler};
  handler systick = systick_handler;
  handler before[38] = {};
  handler usart_2 = usart_2_handler;
};
static_assert(sizeof(vectors) == 4 * (16 + 39));

[[gnu::section(".vectors"), gnu::used]] constinit const vectors table;

}  // namespace
