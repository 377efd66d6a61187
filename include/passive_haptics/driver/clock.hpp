/// @file
/// The clock of a control loop.
#pragma once

#include <cerrno>
#include <concepts>
#include <cstdint>
#include <ctime>

namespace passive_haptics {

/// A clock that a loop can sleep on: now() in ns from any origin; sleep_until(t) returns not before t, or at
/// once if t is past. Tests bring their own.
template <class C>
concept LoopClock = requires(C clock, std::int64_t time) {
  { clock.now() } noexcept -> std::same_as<std::int64_t>;
  { clock.sleep_until(time) } noexcept;
};

/// CLOCK_MONOTONIC, which no one sets. now() is no system call where the kernel offers it without (vDSO).
struct monotonic_clock {
  /// [ns]
  std::int64_t now() const noexcept {
    timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return std::int64_t{1'000'000'000} * t.tv_sec + t.tv_nsec;
  }
  /// Until then [ns]; a signal does not wake it.
  void sleep_until(std::int64_t time) const noexcept {
    const timespec t{static_cast<time_t>(time / 1'000'000'000), static_cast<long>(time % 1'000'000'000)};
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &t, nullptr) == EINTR) {
    }
  }
};

/// CLOCK_MONOTONIC in seconds, as of samples: good to 1e-9 s for 100 days.
inline double monotonic_seconds() noexcept { return 1e-9 * static_cast<double>(monotonic_clock().now()); }

}  // namespace passive_haptics
