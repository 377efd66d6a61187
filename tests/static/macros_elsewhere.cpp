// slow
// Names that are macros on other platforms and in other libraries: no header of ours uses one, so that theirs
// may be included first. The test is that it compiles.
//
// Eigen comes before, as it does not compile behind F and A0 of Arduino and Success of X11, nor behind min,
// max, abs and round of Windows and Arduino; those four are left out here.
#include <gtest/gtest.h>
#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/QR>
#include <boost/hana/basic_tuple.hpp>

// ---- POSIX, Linux
#include <getopt.h>         // no_argument
#include <sys/param.h>      // MIN, MAX, roundup, isset
#include <sys/sysmacros.h>  // major, minor, makedev
#include <termios.h>        // B0, ECHO

// ---- Windows
// minwindef.h, rpcndr.h, objbase.h
#pragma GCC poison near far NEAR FAR small hyper interface IN OUT OPTIONAL CONST VOID TRUE FALSE STRICT PASCAL
#pragma GCC poison CALLBACK cdecl pascal huge
// wingdi.h, winuser.h, winbase.h, winerror.h, math.h
#pragma GCC poison ERROR DELETE RELATIVE ABSOLUTE TRANSPARENT OPAQUE ALTERNATE WINDING INFINITE IGNORE NO_ERROR
#pragma GCC poison DOMAIN SING OVERFLOW UNDERFLOW PLOSS TLOSS GetFirstChild GetNextSibling
// Functions of two forms, for ANSI and Unicode
#pragma GCC poison GetObject GetMessage SendMessage CreateWindow CreateFile DeleteFile CopyFile LoadImage PlaySound
#pragma GCC poison DrawText

// ---- Arduino: Arduino.h of AVR, SAM, ESP32
#pragma GCC poison PI HALF_PI TWO_PI DEG_TO_RAD RAD_TO_DEG EULER HIGH LOW INPUT OUTPUT CHANGE FALLING RISING DEFAULT
#pragma GCC poison EXTERNAL INTERNAL SERIAL DISPLAY sq constrain lowByte highByte bitRead bitSet bitClear bitToggle
#pragma GCC poison bitWrite interrupts noInterrupts B1 B10 A0 A1 D0 D1 SS MOSI MISO SCK SDA SCL
#define F(string) @
#define bit(b) @
#define degrees(rad) @
#define radians(deg) @
#define word(...) @

// ---- Microcontrollers
// avr/io.h, avr/interrupt.h, avr/sfr_defs.h
#pragma GCC poison _BV cli sei cbi sbi SREG SP PORTB DDRB PINB loop_until_bit_is_set
// ctype.h of newlib
#pragma GCC poison _U _L _N _S _P _C _X _B
// CMSIS, HAL
#pragma GCC poison __I __O __IO SET RESET ENABLE DISABLE SUCCESS READ_BIT SET_BIT READ_REG FLASH RCC TIM1 GPIOA UNUSED
// NuttX, VxWorks, Zephyr, ESP-IDF
#pragma GCC poison CODE IMPORT LOCAL FAST READ WRITE BIT BIT0 CLAMP CONTAINER_OF

// ---- X11: X.h, Xlib.h
#pragma GCC poison None Bool Status Success True False Always Complex Nonconvex Convex CursorShape KeyPress KeyRelease
#pragma GCC poison FocusIn FocusOut Expose Above Below Opposite TopIf BottomIf Unsorted YSorted WhenMapped NotUseful
#pragma GCC poison GrayScale StaticColor PseudoColor BadRequest BadValue GenericEvent AnyKey Button1 LockMask
#pragma GCC poison ControlMask DestroyAll DefaultScreen

// ---- Qt: qobjectdefs.h, qforeach.h
#pragma GCC poison signals slots emit foreach forever SIGNAL SLOT METHOD Q_OBJECT

// ---- curses.h, which takes back box, clear, erase and move for C++; term.h is left out, which renames
// hundreds of words, such as columns
#pragma GCC poison OK ERR stdscr curscr LINES COLS COLOR_RED getch addch addstr insch delch bkgd attron standout
#define border(l, r, t, b, tl, tr, bl, br) @
#define timeout(delay) @

// ---- macOS: AssertMacros.h, objc.h
#pragma GCC poison verify verify_noerr check_noerr require_noerr require_action debug_assert nil Nil YES NO
#define check(assertion) @
#define require(assertion, label) @

// ---- Other libraries: C's complex.h, Unreal Engine, glog, Catch2
#pragma GCC poison I complex imaginary verifyf checkf ensure LOG VLOG DLOG CHECK DCHECK REQUIRE VERIFY ASSERT EXPECT

// ---- What programs define themselves
#pragma GCC poison ABS SIGN SQR ARRAY_SIZE container_of linux unix

#include <passive_haptics/passive_haptics.hpp>

#include <firmware/brake_controller.hpp>  // for microcontrollers
#include <firmware/byte_queue.hpp>

#undef word                  // Arduino has no files
#include <every_header.hpp>  // made by CMake

static_assert((passive_haptics::radians)(180.0) == std::numbers::pi);
static_assert((passive_haptics::degrees)(std::numbers::pi) == 180);
