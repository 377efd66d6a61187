/// Registers for board.cpp, of an STM32F405/407 (reference manual RM0090).
#pragma once

#include <firmware/cortex_m.hpp>

namespace registers {

using cortex_m::at, cortex_m::reg;

struct rcc_block {
  reg cr, pllcfgr, cfgr, cir, ahb1rstr, ahb2rstr, ahb3rstr, reserved_1, apb1rstr, apb2rstr, reserved_2[2];
  reg ahb1enr, ahb2enr, ahb3enr, reserved_3, apb1enr, apb2enr;
};
struct flash_block {
  reg acr;
};
struct gpio_block {
  reg moder, otyper, ospeedr, pupdr, idr, odr, bsrr, lckr, afr[2];
};
struct timer_block {
  reg cr1, cr2, smcr, dier, sr, egr, ccmr1, ccmr2, ccer, cnt, psc, arr, rcr, ccr[4];
};
struct usart_block {
  reg sr, dr, brr, cr1, cr2, cr3;
};
struct watchdog_block {
  reg kr, pr, rlr, sr;
};

static_assert(sizeof(rcc_block) == 0x48 && sizeof(gpio_block) == 0x28 && sizeof(timer_block) == 0x44);

inline rcc_block& rcc() { return at<rcc_block>(0x4002'3800); }
inline flash_block& flash() { return at<flash_block>(0x4002'3C00); }
inline gpio_block& gpio_a() { return at<gpio_block>(0x4002'0000); }
inline gpio_block& gpio_b() { return at<gpio_block>(0x4002'0400); }
inline gpio_block& gpio_c() { return at<gpio_block>(0x4002'0800); }
inline timer_block& timer_2() { return at<timer_block>(0x4000'0000); }
inline timer_block& timer_3() { return at<timer_block>(0x4000'0400); }
inline timer_block& timer_5() { return at<timer_block>(0x4000'0C00); }
inline usart_block& usart_2() { return at<usart_block>(0x4000'4400); }
inline watchdog_block& watchdog() { return at<watchdog_block>(0x4000'3000); }

}  // namespace registers
