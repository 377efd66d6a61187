/// @file
/// What can go wrong while brakes hold, who notices it, and the longest time until 0 A.
#pragma once

#include <passive_haptics/driver/control_loop.hpp>
#include <passive_haptics/driver/process/supervisor.hpp>
#include <passive_haptics/driver/safe_port_parameters.hpp>
#include <passive_haptics/driver/thread/polling_thread.hpp>

#include <limits>
#include <string_view>
#include <vector>

namespace passive_haptics {

/// The parameters of a driver on which these times depend.
struct driver_timing {
  control_loop_parameters loop;                               ///< Its period and overruns.
  double hold_over = safe_port_parameters<1, 0>().hold_over;  ///< Of the safe_port [s].
  release_parameters at_release;                              ///< Of the safe_port and the supervisor.
  supervisor_parameters supervisor;                           ///< Its timeout.
  polling_parameters thread;                                  ///< Of the threaded_port.
  double bench_hold_over = 0.1;                               ///< Of record_on_bench() [s],
  double bench_overtime = 1;                                  ///< and how long it waits for the end [s].
  double watchdog = 0;                                        ///< Of the device [s]; 0 for none.
};

/// One thing that can go wrong.
struct hazard {
  std::string_view what;      ///< What happens.
  std::string_view found_by;  ///< Who notices it.
  double longest = 0;         ///< The longest time from what happens to the order of 0 A [s]; inf: never.
  std::string_view after;     ///< How the brakes can be driven again.
};

/// All hazards of a driver with a safe_port, a control_loop, a supervisor and a threaded_port, each with the
/// longest time until 0 A is ordered where the processes get the processor. The transfer of that order comes
/// on top. Source: each time is that of the parameter, or constant, which the formula names.
inline std::vector<hazard> hazards(const driver_timing& p = {}) {
  constexpr double never = std::numeric_limits<double>::infinity();
  const double cycle = p.loop.period, hold_over = p.hold_over, supervised = p.supervisor.latest();
  // A release by the loop, and by a supervisor that the loop does not come back to
  const bool holds = p.at_release.policy == release_policy::hold;
  const double by_loop = holds ? never : p.at_release.longest(), by_supervisor = p.at_release.longest();
  constexpr std::string_view rearm = "rearm", homing = "start again, with homing", ends = "it ends";
  return {
      {"An encoder's count is NaN, infinite, beyond its counter or a jump, the device calls it invalid, or "
       "samples are out of order",
       "safe_port: for `hold_over`", hold_over + cycle + by_loop, homing},
      {"No sample, the same one again, a damaged one (checksum, cut off), one older than `hold_over` or "
       "ahead "
       "of the clock",
       "safe_port: for `hold_over`", hold_over + cycle + by_loop, rearm},
      {"The device refuses currents", "safe_port: for `hold_over`", hold_over + cycle + by_loop, rearm},
      {"The force sensor is silent, stale, damaged, NaN, invalid or saturated", "safe_port: for `hold_over`",
       hold_over + cycle + by_loop, rearm},
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
      {"The clock goes back or is NaN", "control_loop, safe_port", cycle + by_loop, rearm},
      {"More than `max_overruns` cycles in a row end late", "control_loop",
       (p.loop.max_overruns + 1) * supervised + by_loop, rearm},
      {"The law throws", "control_loop", cycle + by_supervisor, ends},
      {"SIGINT, SIGTERM, SIGHUP, the end of `--seconds`", "the loop", cycle + by_supervisor, ends},
      {"The program destroys its ports while the brakes hold: a return, an exception", "the port's thread",
       p.thread.pause, ends},
      {"The loop's process dies: SIGKILL, SIGSEGV, SIGABRT, SIGBUS, SIGQUIT", "supervisor: its pipe closes",
       by_supervisor, ends},
      {"It dies where the system refuses `close_range`", "supervisor: its pipe closes", by_supervisor, ends},
      {"The loop is stopped (SIGSTOP), or a cycle hangs", "supervisor: no heartbeat",
       supervised + by_supervisor, rearm},
      {"The loop is stopped, and a rearm request (SIGUSR1) waits for it", "supervisor: no heartbeat",
       supervised + by_supervisor, "another rearm request"},
      {"The loop is stopped for longer than a release lasts, and goes on", "supervisor: no heartbeat",
       supervised + by_supervisor, rearm},
      {"A transfer of a threaded port does not return", "safe_port: for `hold_over`, then no heartbeat",
       hold_over + 2 * cycle + supervised + by_supervisor, "rearm, if it returns"},
      {"The supervisor dies or is stopped", "the loop", p.supervisor.lost() + cycle + by_loop,
       "start the program again"},
      {"Loop and supervisor die or are stopped", "the device's watchdog", p.watchdog > 0 ? p.watchdog : never,
       "start the program again"},
      {"On a bench: a bad sample, a refused current, a clock that stands still or jumps", "record_on_bench",
       p.bench_hold_over + cycle, "start the test again"},
      {"On a bench: the test does not end by its samples", "record_on_bench: this machine's clock",
       p.bench_overtime, "start the test again"},
      {"Standard input, output or error is closed when the program starts",
       "the program, before it opens any", 0, "no brake is driven before"},
      {"The handle is deeper in a wall than `largest_start_depth`", "brake_driver, before `activate()`", 0,
       "move the handle out"},
  };
}

}  // namespace passive_haptics
