// From reset to main(): vector table and memory initialisation. Belongs to cortex_m.ld.
#include <board.hpp>
#include <firmware/cortex_m.hpp>

#include <array>
#include <cstddef>

extern "C" {
extern std::uint32_t stack_top, data_source, data_begin, data_end, bss_begin, bss_end;

int main();

[[noreturn]] void reset_handler() {
  const std::uint32_t* from = &data_source;
  for (std::uint32_t* to = &data_begin; to < &data_end;) *to++ = *from++;
  for (std::uint32_t* to = &bss_begin; to < &bss_end;) *to++ = 0;
  main();
  for (;;) {
  }
}

// Any fault or unexpected interrupt: waits for the watchdog's reset.
[[noreturn]] void stop_handler() {
  for (;;) {
  }
}
}

namespace {

using handler = void (*)();

constexpr std::size_t lines = [] {
  int last = 0;
  for (const auto& one : interrupts) last = one.line > last ? one.line : last;
  return static_cast<std::size_t>(last) + 1;
}();

constexpr std::array<handler, lines> handlers = [] {
  std::array<handler, lines> all{};
  all.fill(stop_handler);
  for (const auto& one : interrupts) all[static_cast<std::size_t>(one.line)] = one.handler;
  return all;
}();

struct vectors {
  std::uint32_t* stack = &stack_top;
  handler reset = reset_handler;
  handler faults[9] = {stop_handler, stop_handler, stop_handler, stop_handler, stop_handler};
  handler calls[4] = {stop_handler, stop_handler, nullptr, stop_handler};
  handler systick = systick_handler;
  std::array<handler, lines> external = handlers;
};
static_assert(sizeof(vectors) == 4 * (16 + lines));

[[gnu::section(".vectors"), gnu::used]] constinit const vectors table;

}  // namespace
