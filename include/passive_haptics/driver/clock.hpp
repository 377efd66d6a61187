/// @file
/// The clock of a control loop.
#pragma once

#include <cerrno>
#include <concepts>
#include <cstdint>
#include <ctime>

namespace passive_haptics {

/// A clock that a loop can sleep on: now() in ns from any origin; sleep_until(t) returns not before t, or
/// immediately if t is past. Tests bring their own.
///
/// A clock that stands still while the machine is suspended may also have `std::int64_t boot_time() noexcept`
/// [ns, from any origin], which goes on meanwhile. control_loop then notices that the machine was suspended.
template <class C>
concept LoopClock = requires(C clock, std::int64_t time) {
  { clock.now() } noexcept -> std::same_as<std::int64_t>;
  { clock.sleep_until(time) } noexcept;
};

/// CLOCK_MONOTONIC, which no one sets. now() and boot_time() are no system calls if the kernel offers them
/// without (vDSO).
struct monotonic_clock {
  /// [ns]
  std::int64_t now() const noexcept { return read(CLOCK_MONOTONIC); }
  /// CLOCK_BOOTTIME [ns]: now() and the time for which the machine was suspended.
  std::int64_t boot_time() const noexcept { return read(CLOCK_BOOTTIME); }
  /// Until then [ns]; a signal does not wake it.
  void sleep_until(std::int64_t time) const noexcept {
    const timespec t{static_cast<time_t>(time / 1'000'000'000), static_cast<long>(time % 1'000'000'000)};
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &t, nullptr) == EINTR) {
    }
  }

 private:
  static std::int64_t read(clockid_t clock) noexcept {
    timespec t;
    clock_gettime(clock, &t);
    return std::int64_t{1'000'000'000} * t.tv_sec + t.tv_nsec;
  }
};

/// CLOCK_MONOTONIC in seconds, as of samples: good to 1e-9 s for 100 days.
inline double monotonic_seconds() noexcept { return 1e-9 * static_cast<double>(monotonic_clock().now()); }

}  // namespace passive_haptics
