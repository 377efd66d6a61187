/// A loop with absolute wake-up times.
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/driver/clock.hpp>
#include <passive_haptics/driver/duration_histogram.hpp>
#include <passive_haptics/driver/fault.hpp>

#include <cmath>
#include <concepts>
#include <cstdint>
#include <exception>
#include <string>
#include <utility>

namespace passive_haptics {

/// Parameters of control_loop.
struct control_loop_parameters {
  double period = 1e-3;  ///< [s]; section 5.1: 1 kHz.
  int max_overruns = 5;  ///< Allowed number of successive cycles that end late; one more releases the brakes.
  double max_sleep = 0.1;  ///< Maximum delay of a wake-up; a longer one releases the brakes [s].

  static constexpr auto members() {
    using p = control_loop_parameters;
    return member_table(
        member("period", &p::period, "s", range::between(1e-6, 1)),
        member("max_overruns", &p::max_overruns, "", range::at_least(0)).suspicious_above(1e6),
        member("max_sleep", &p::max_sleep, "s", range::positive).suspicious_above(10));
  }
};

/// A cycle of the loop.
struct loop_cycle {
  std::int64_t number = 0;  ///< Number of periods since the start, including missed ones.
  double time = 0;          ///< Start on the loop's clock [s].
  double late = 0;          ///< Delay of the start [s].
};

/// Statistics of a loop.
struct loop_report {
  std::uint64_t cycles = 0;      ///< Cycles that ran.
  std::uint64_t missed = 0;      ///< Cycles skipped after a long one.
  std::uint64_t overruns = 0;    ///< Cycles that ended after the next should have begun.
  duration_histogram late;       ///< Delays of the starts.
  duration_histogram compute;    ///< Durations of the cycles.
  fault ended_by = fault::none;  ///< none, or law_failed if the cycle threw.
  std::string exception;         ///< Text of the exception.
};

/// Wakes at start + k period, so that delays do not accumulate; cycles missed during a long one are skipped.
template <LoopClock Clock = monotonic_clock>
class control_loop {
 public:
  /// Throws std::invalid_argument with the text of validate(p).
  explicit control_loop(const control_loop_parameters& p = {}, Clock clock = {})
      : p_(require_valid(p)), clock_(std::move(clock)), period_(std::llround(1e9 * p.period)) {
#if defined(__cpp_exceptions)
    // Preloads the code for exceptions, which takes as long as a cycle
    try {
      throw 0;
    } catch (int) {
    }
#endif
  }

  /// Runs until stop() is true or cycle(loop_cycle) is false; between cycles only the clock is called. Calls
  /// release(fault), which must not throw, before it returns, and if the loop is late, the clock jumps or the
  /// machine was suspended; the loop then continues, so that the user can rearm. An exception of the cycle
  /// ends the loop and is stored in the report.
  template <class Cycle, class Stop, class Release>
  loop_report run(Cycle&& cycle, Stop&& stop, Release&& release) {
    loop_report report;
    const std::int64_t start = clock_.now();
    std::int64_t number = 0;
    int overruns = 0;
    // Slightly too long if anything came between the two clocks; below, slightly too short
    std::int64_t suspended = boot_time() - start;
    while (!stop()) {
      const std::int64_t deadline = start + ++number * period_;
      clock_.sleep_until(deadline);
      const std::int64_t booted = boot_time();
      const std::int64_t begin = clock_.now(), late = begin - deadline;
      if (has_boot_time && booted - begin > suspended + period_) {
        release(fault::suspended);
        suspended = boot_time() - begin;
      }
      // No cycle ends after the next deadline, so an earlier time means that the clock went back
      if (late < 0) release(fault::clock_jump);
      else if (static_cast<double>(late) > 1e9 * p_.max_sleep) release(fault::cycle_late);
      report.late.add(late);
      const loop_cycle now{number, 1e-9 * static_cast<double>(begin), 1e-9 * static_cast<double>(late)};
      bool go_on = false;
#if defined(__cpp_exceptions)
      const auto fail = [&](const char* thrown) {
        release(report.ended_by = fault::law_failed);
        report.exception = thrown;
      };
      try {
        go_on = cycle(now);
      } catch (const std::exception& e) {
        fail(e.what());
      } catch (...) {
        fail("an exception that is not a std::exception");
      }
#else
      go_on = cycle(now);
#endif
      const std::int64_t end = clock_.now();
      ++report.cycles;
      report.compute.add(end - begin);
      if (!go_on) break;

      if (end <= deadline + period_) {
        overruns = 0;
        continue;
      }
      ++report.overruns;
      if (++overruns > p_.max_overruns) release(fault::overruns);
      const std::int64_t past = (end - start) / period_ - number;
      report.missed += static_cast<std::uint64_t>(past);
      number += past;
    }
    release(report.ended_by == fault::none ? fault::user : report.ended_by);
    return report;
  }

 private:
  static constexpr bool has_boot_time = requires(Clock clock) {
    { clock.boot_time() } noexcept -> std::same_as<std::int64_t>;
  };
  std::int64_t boot_time() noexcept {
    if constexpr (has_boot_time) return clock_.boot_time();
    else return 0;
  }

  control_loop_parameters p_;
  Clock clock_;
  std::int64_t period_;  // [ns]
};

}  // namespace passive_haptics
