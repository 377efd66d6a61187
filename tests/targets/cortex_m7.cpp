// From reset to main(), output by semihosting and a clock, on an Arm MPS2 with the image AN500 (Cortex-M7).
#include "output.hpp"

#include <cstdint>

extern "C" {
extern std::uint32_t stack_top, data_source, data_begin, data_end, bss_begin, bss_end;
int main(int, char**);
}

namespace {

constexpr int write_0 = 0x04, exit_extended = 0x20;  // of Arm's semihosting
constexpr std::uint32_t application_exit = 0x20026;

void semihosting(int operation, const void* argument) {
  register int r0 asm("r0") = operation;
  register const void* r1 asm("r1") = argument;
  asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
}

[[noreturn]] void end(int code) {
  const std::uint32_t block[] = {application_exit, static_cast<std::uint32_t>(code)};
  semihosting(exit_extended, block);
  for (;;) {
  }
}

}  // namespace

extern "C" [[noreturn]] void reset_handler() {
  *reinterpret_cast<volatile std::uint32_t*>(0xE000'ED88) |= 0xF00000;  // the floating-point unit
  asm volatile("dsb\nisb" ::: "memory");
  const std::uint32_t* from = &data_source;
  for (std::uint32_t* to = &data_begin; to < &data_end;) *to++ = *from++;
  for (std::uint32_t* to = &bss_begin; to < &bss_end;) *to++ = 0;
  end(main(0, nullptr));
}

namespace {

[[noreturn]] void fault() { end(3); }

using handler = void (*)();
struct vectors {
  std::uint32_t* stack = &stack_top;
  handler start = reset_handler;
  handler faults[5] = {fault, fault, fault, fault, fault};
};
[[gnu::section(".vectors"), gnu::used]] constinit const vectors table;

}  // namespace

void output::write(const char* text) { semihosting(write_0, text); }
