/// @file
/// A second process that releases the brakes when the loop's process cannot.
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/driver/clock.hpp>
#include <passive_haptics/driver/port.hpp>
#include <passive_haptics/driver/process/child_process.hpp>
#include <passive_haptics/driver/process/shared_memory.hpp>

#include <sched.h>
#include <sys/mman.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

namespace passive_haptics {

/// How long a supervisor waits.
struct supervisor_parameters {
  double timeout = 0.010;  ///< Without a heartbeat for so long, the brakes are released [s].
  int priority = 0;        ///< SCHED_FIFO priority of its process, over the loop's; 0 for none.

  static constexpr const char* owner = "the supervisor";  ///< In errors.
  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = supervisor_parameters;
    return member_table(member("timeout", &p::timeout, "s", range::between(0.004, 10), plausible(0.004, 1)),
                        member("priority", &p::priority, "", range::between(0, 99).as("0 (none) to 99")));
  }
};

/// Analog outputs keep their last value when a process dies. A supervisor is a process with a port of its own
/// to the same device; it calls release() when the loop's process dies (at once: their pipe closes) or its
/// heartbeat stops for `timeout`, as of SIGSTOP or a cycle that hangs. It looks four times in that time, so
/// it is never later than 1.25 timeouts where it gets the processor; and it goes on releasing until rearm().
///
/// Start it before the loop's real-time set-up and before any thread.
template <BrakePort Port>
class supervisor {
  static_assert(
      !requires { typename Port::port_type; },
      "passive_haptics: a supervisor may wait, so it takes the port itself: threaded_port::port_type");

 public:
  /// The port must not be open. Throws std::invalid_argument with the text of validate(p).
  explicit supervisor(Port port, const supervisor_parameters& p = {})
      : port_(std::move(port)), p_(require_valid(p)) {}

  /// Forks the process, which opens its port; empty, or why it could not.
  std::string start() {
    return child_.start([this] { return port_.open(); }, [this](parent_link parent) { watch(parent); });
  }

  /// Once a cycle, with its time [s]; the first beat starts the watch. False where the supervisor released
  /// the brakes, or has not been seen for 0.1 s, or for `timeout` where that is longer: release them here,
  /// too.
  bool beat(double now) noexcept {
    shared_->beats.fetch_add(1, std::memory_order_relaxed);
    const std::uint32_t looks = shared_->looks.load(std::memory_order_relaxed);
    if (looks != looks_ || !std::isfinite(seen_)) {
      looks_ = looks;
      seen_ = now;
    }
    alive_ = now - seen_ < std::max(lost_after, p_.timeout);  // it looks four times in a timeout
    return alive_ && !released();
  }

  /// Whether it was there at the last beat: nothing is to be rearmed without it.
  bool alive() const noexcept { return alive_; }

  /// Whether it released the brakes.
  bool released() const noexcept { return shared_->released.load(std::memory_order_acquire); }
  /// Lets the loop's currents flow again.
  void rearm() noexcept { shared_->released.store(false, std::memory_order_release); }
  /// Ends it; it releases the brakes once more.
  void stop() noexcept { child_.stop(); }
  /// Its process number; <= 0 if it does not run.
  pid_t pid() const noexcept { return child_.pid(); }

 private:
  static constexpr double lost_after = 0.1;  // [s]
  struct heart {
    std::atomic<std::uint32_t> beats = 0, looks = 0;
    std::atomic<bool> released = false;
  };
  static_assert(std::atomic<std::uint32_t>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

  void watch(parent_link parent) noexcept {
    be_quick();
    const auto timeout = std::llround(1e9 * p_.timeout);
    const int look = std::max(1, static_cast<int>(1e3 * p_.timeout / 4));  // [ms]
    std::uint32_t last = 0;
    std::int64_t beaten = monotonic_clock().now();
    while (!parent.gone(look)) {
      const std::int64_t now = monotonic_clock().now();
      const std::uint32_t beats = shared_->beats.load(std::memory_order_relaxed);
      if (beats != last || beats == 0) beaten = now;
      else if (now - beaten > timeout) shared_->released.store(true, std::memory_order_release);
      last = beats;
      if (released()) port_.release();
      shared_->looks.fetch_add(1, std::memory_order_relaxed);
    }
    port_.release();
  }

  // Refusals change nothing but how soon it is
  void be_quick() noexcept {
    mlockall(MCL_CURRENT | MCL_FUTURE);
    if (p_.priority == 0) return;
    sched_param priority{};
    priority.sched_priority = p_.priority;
    sched_setscheduler(0, SCHED_FIFO, &priority);
  }

  Port port_;
  supervisor_parameters p_;
  shared_memory<heart> shared_;
  child_process child_;
  std::uint32_t looks_ = 0;
  double seen_ = -std::numeric_limits<double>::infinity();  // [s]
  bool alive_ = false;
};

}  // namespace passive_haptics
