/// The clock of a control loop.
#pragma once

#include <cerrno>
#include <concepts>
#include <cstdint>
#include <ctime>

namespace passive_haptics {

/// A clock for control loops: now() in ns from any origin; sleep_until(t) returns not before t. Optional:
/// `std::int64_t boot_time() noexcept` [ns], which also runs while the machine is suspended, so that
/// control_loop detects that.
template <class C>
concept LoopClock = requires(C clock, std::int64_t time) {
  { clock.now() } noexcept -> std::same_as<std::int64_t>;
  { clock.sleep_until(time) } noexcept;
};

/// CLOCK_MONOTONIC, which cannot be set. now() and boot_time() usually need no system call (vDSO).
struct monotonic_clock {
  std::int64_t now() const noexcept { return read(CLOCK_MONOTONIC); }  ///< [ns]
  /// CLOCK_BOOTTIME [ns], which includes suspended time.
  std::int64_t boot_time() const noexcept { return read(CLOCK_BOOTTIME); }
  /// Sleeps until a time [ns], also after signals.
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

/// CLOCK_MONOTONIC in seconds, as in samples; resolves 1e-9 s for 100 days.
inline double monotonic_seconds() noexcept { return 1e-9 * static_cast<double>(monotonic_clock().now()); }

}  // namespace passive_haptics
