/// Hazards while brakes hold, their detection, and the maximum time until 0 A.
#pragma once

#include <passive_haptics/driver/control_loop.hpp>
#include <passive_haptics/driver/process/supervisor.hpp>
#include <passive_haptics/driver/safe_port_parameters.hpp>
#include <passive_haptics/driver/thread/polling_thread.hpp>

#include <algorithm>
#include <limits>
#include <string_view>
#include <vector>

namespace passive_haptics {

/// Parameters of a driver and of an idle machine that determine these times.
struct driver_timing {
  control_loop_parameters loop;                               ///< Period and overruns.
  double hold_over = safe_port_parameters<1, 0>().hold_over;  ///< safe_port [s].
  release_parameters at_release;                              ///< safe_port and supervisor.
  supervisor_parameters supervisor;                           ///< Timeout.
  polling_parameters thread;                                  ///< threaded_port.
  double bench_hold_over = 0.1;                               ///< record_on_bench() [s].
  double bench_overtime = 1;                                  ///< Maximum overtime of record_on_bench() [s].
  double watchdog = 0;                                        ///< Watchdog of the device [s]; 0 for none.
  /// Maximum wake-up delay of a process [s]: 0.05 ms timer slack (prctl(2)), 0.1 ms to leave an idle state.
  double wake_up = 1.5e-4;
  /// Time for the kernel to end a killed process [s]: it frees the memory before it closes the pipe, about
  /// 0.07 ms per MiB; 2 ms suffice for 28 MiB, or 8 MiB on a virtual machine.
  double process_end = 2e-3;
};

/// One thing that can go wrong.
struct hazard {
  std::string_view what;      ///< Event.
  std::string_view found_by;  ///< Detection.
  double max_time = 0;        ///< Maximum time from the event to the command of 0 A [s]; inf: never.
  std::string_view after;     ///< Recovery.
};

/// All hazards of a driver with a safe_port, a control_loop, a supervisor and a threaded_port, with the
/// maximum time until 0 A is commanded on an idle machine; `benchmarks/run hazards` measures them.
inline std::vector<hazard> hazards(const driver_timing& p = {}) {
  constexpr double never = std::numeric_limits<double>::infinity();
  // Time to the next cycle; from the last good sample or write to the releasing cycle
  const double cycle = p.loop.period + p.wake_up, held = p.hold_over + cycle;
  const double supervised = p.supervisor.latest(p.wake_up);  // from the last heartbeat
  // The last current of a release that takes time is followed by 0 A
  const double lasts = p.at_release.max_duration();
  const double next = std::max(cycle, p.supervisor.release_interval + p.wake_up);
  // For a supervisor without the loop, and for the loop
  const double by_supervisor = lasts > 0 ? lasts + next : 0;
  const double by_loop = p.at_release.policy == release_policy::hold ? never : by_supervisor;
  constexpr std::string_view rearm = "rearm", homing = "start again, with homing", ends = "it ends";
  return {
      {"An encoder's count is NaN, infinite, beyond its counter or a jump, the device calls it invalid, or "
       "samples are out of order",
       "safe_port: for `hold_over`", held + by_loop, homing},
      {"No sample, the same one again, a damaged one (checksum, cut off), one older than `hold_over` or "
       "ahead "
       "of the clock",
       "safe_port: for `hold_over`", held + by_loop, rearm},
      {"The device rejects currents", "safe_port: for `hold_over`", held + by_loop, rearm},
      {"The device rejects currents and the release", "safe_port: for `hold_over`, then no heartbeat",
       held + supervised + by_supervisor, "rearm, if it accepts them again"},
      {"The force sensor is silent, stale, damaged, NaN, invalid or saturated", "safe_port: for `hold_over`",
       held + by_loop, rearm},
      {"The device is lost, while reading or writing, or restarted", "safe_port", cycle, homing},
      {"The force sensor is lost", "safe_port", cycle + by_loop, "rearm, if it comes back"},
      {"An encoder stands still while the others turn `frozen_travel` and no brake holds", "safe_port", cycle,
       homing},
      {"Of the encoders' samples within ten `hold_over`, a quarter are NaN, infinite, beyond the counter, "
       "jumps or invalid",
       "safe_port", 10 * p.hold_over + cycle + by_loop, homing},
      {"Of the samples within ten `hold_over`, a quarter are damaged, or of the force sensor NaN, infinite, "
       "invalid or saturated",
       "safe_port", 10 * p.hold_over + cycle + by_loop, rearm},
      {"A counter may have wrapped unseen in a pause (`wrap_time`)", "safe_port", cycle + by_loop, homing},
      {"A command is NaN, infinite or negative", "safe_port", cycle + by_loop, rearm},
      {"The clock is NaN, or goes back", "control_loop, safe_port; supervisor: no heartbeat",
       std::max(cycle + by_loop, supervised + by_supervisor), rearm},
      {"The machine goes on after a suspend, in which only the device's watchdog can act",
       "control_loop: CLOCK_BOOTTIME", cycle + by_loop, homing},
      // The supervisor accepts each of these cycles
      {"More than `max_overruns` cycles in a row end late", "control_loop",
       cycle + (p.loop.max_overruns + 1) * supervised + by_loop, rearm},
      {"The law throws", "control_loop", cycle + by_supervisor, ends},
      {"SIGINT, SIGTERM, SIGHUP, the end of `--seconds`", "the loop", cycle + by_supervisor, ends},
      {"The program destroys its ports while the brakes hold: a return, an exception", "the port's thread",
       p.thread.pause + p.wake_up, ends},
      // If the kernel takes long, the missing heartbeat is detected first
      {"The loop's process dies: SIGKILL, SIGSEGV, SIGABRT, SIGBUS, SIGQUIT or another signal that ends it",
       "supervisor: its pipe closes", std::min(p.process_end + p.wake_up, supervised) + by_supervisor, ends},
      {"It dies where the system refuses `close_range`", "supervisor: its pipe closes",
       std::min(p.process_end + p.wake_up, supervised) + by_supervisor, ends},
      {"The loop is stopped (SIGSTOP), a cycle hangs, or the kernel writes the core of a loop that died",
       "supervisor: no heartbeat", supervised + by_supervisor, "rearm, if it goes on"},
      {"The loop is stopped, and a rearm request (SIGUSR1) waits for it", "supervisor: no heartbeat",
       supervised + by_supervisor, "another rearm request"},
      {"The loop is stopped for longer than a release lasts, and goes on", "supervisor: no heartbeat",
       supervised + by_supervisor, rearm},
      {"A transfer of a threaded port does not return", "safe_port: for `hold_over`, then no heartbeat",
       held + cycle + supervised + by_supervisor, "rearm, if it returns"},
      // The loop sees the supervisor's last look in its next cycle and starts counting there
      {"The supervisor dies or is stopped", "the loop", cycle + p.supervisor.lost() + cycle + by_loop,
       "start the program again"},
      {"Loop and supervisor die or are stopped", "the device's watchdog", p.watchdog > 0 ? p.watchdog : never,
       "start the program again"},
      {"On a bench: a bad sample, a rejected current, a clock that stands still or jumps", "record_on_bench",
       p.bench_hold_over + cycle, "start the test again"},
      {"On a bench: the test does not end by its samples", "record_on_bench: this machine's clock",
       p.bench_overtime + cycle, "start the test again"},
      {"Standard input, output or error is closed when the program starts",
       "the program, before it opens any", 0, "no brake is driven before"},
      {"The handle is deeper in a wall than `max_start_depth`", "brake_driver, before `activate()`", 0,
       "move the handle out"},
  };
}

}  // namespace passive_haptics
