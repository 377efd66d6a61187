/// A process that releases the brakes if the loop's process cannot.
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/driver/checks/current_limiter.hpp>
#include <passive_haptics/driver/clock.hpp>
#include <passive_haptics/driver/port.hpp>
#include <passive_haptics/driver/process/child_process.hpp>
#include <passive_haptics/driver/process/shared_memory.hpp>
#include <passive_haptics/driver/release_policy.hpp>

#include <poll.h>
#include <sched.h>
#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>

namespace passive_haptics {

/// Parameters of supervisor.
struct supervisor_parameters {
  double timeout = 0.010;  ///< Maximum time without a heartbeat [s].
  int priority = 0;        ///< SCHED_FIFO priority of its process, above the loop's; 0 for none.

  double look() const noexcept { return timeout / 4; }  ///< Interval of its checks [s].
  /// Maximum time from the last heartbeat to the release [s], with wake-up delays of at most `wake_up` [s]:
  /// one check to notice that heartbeat, and four for the timeout.
  double latest(double wake_up = 0) const noexcept { return 5 * (look() + wake_up); }
  /// Time without a check after which the loop considers it lost [s].
  double lost() const noexcept { return std::max(0.1, timeout); }
  static constexpr double release_interval = 2e-3;  ///< Interval of the currents of a release [s].

  static constexpr const char* type_name = "the supervisor";  ///< In errors.
  static constexpr auto members() {
    using p = supervisor_parameters;
    return member_table(member("timeout", &p::timeout, "s", range::between(0.004, 10)),
                        member("priority", &p::priority, "", range::between(0, 99).as("0 (none) to 99")));
  }
};

/// A process with its own port to the device, because analog outputs keep their last value when a process
/// dies. It releases the brakes by the release policy if the loop's process dies (their pipe closes) or its
/// heartbeat stops for `timeout`, within 1.25 timeouts, and continues until rearm(). If the loop does not
/// return, it sets 0 A after release_parameters::max_duration(). If both are dead or stopped, only the
/// device's watchdog remains. Start it before the loop's real-time set-up and before any thread.
template <class Port>
class supervisor {
  static_assert(is_port<Port, explain>());
  static_assert(
      !requires { typename Port::port_type; },
      "passive_haptics: a supervisor may wait; pass the port itself, threaded_port::port_type");

 public:
  static constexpr int brake_count = Port::brake_count;  ///< Number of brakes.
  using currents = brake_currents<brake_count>;          ///< [A]

  /// The port must not be open. Release policy and current limits should be those of the safe_port. Throws
  /// std::invalid_argument with the text of validate().
  explicit supervisor(Port port, const supervisor_parameters& p = {},
                      const release_parameters& at_release = {},
                      const current_limits<brake_count>& limits = {})
      : port_(std::move(port)), p_(require_valid(p)), release_(at_release), limiter_(limits) {}

  /// Forks the process, which opens its port. Returns an error or an empty string.
  std::string start() {
    return child_.start([this] { return port_.open(); }, [this](parent_link parent) { watch(parent); });
  }

  /// Heartbeat, once per cycle, with its time [s, CLOCK_MONOTONIC] and the applied currents [A]; NaN currents
  /// do not count. Returns false if the supervisor released the brakes or was not seen for lost() seconds:
  /// release them in the loop, too, from began() on.
  bool beat(double now, const currents& flowing) noexcept {
    if (std::all_of(flowing.begin(), flowing.end(), [](double current) { return std::isfinite(current); })) {
      store(shared_->flowing, flowing);
      shared_->beats.fetch_add(1, std::memory_order_release);
    }
    const std::uint32_t looks = shared_->looks.load(std::memory_order_relaxed);
    if (looks != looks_ || !std::isfinite(seen_)) {
      looks_ = looks;
      seen_ = now;
    }
    alive_ = now - seen_ < p_.lost();
    return alive_ && !released();
  }

  /// True if it was seen at the last beat; required for rearming.
  bool alive() const noexcept { return alive_; }

  /// True if it released the brakes.
  bool released() const noexcept { return shared_->released.load(std::memory_order_acquire); }
  /// Start of its release, for the loop to continue; empty without a release.
  std::optional<release_start<brake_count>> began() const noexcept {
    if (!released()) return {};
    return release_start<brake_count>{shared_->began.load(std::memory_order_relaxed), load(shared_->from)};
  }
  /// Allows the loop's currents again.
  void rearm() noexcept { shared_->released.store(false, std::memory_order_release); }
  /// Ends it after the loop released the brakes, with a last 0 A. Takes two seconds at most, three if it is
  /// killed.
  void stop() noexcept {
    shared_->dismissed.store(true, std::memory_order_release);
    child_.stop(2);
  }
  pid_t pid() const noexcept { return child_.pid(); }  ///< Process number; <= 0 if it does not run.

 private:
  using shared_currents = std::array<std::atomic<double>, static_cast<std::size_t>(brake_count)>;
  struct heart {
    std::atomic<std::uint32_t> beats = 0, looks = 0;
    std::atomic<bool> released = false, dismissed = false;
    shared_currents flowing{}, from{};  // currents of the loop, and at the start of the release [A]
    std::atomic<double> began = 0;      // [s]
  };
  static_assert(std::atomic<std::uint32_t>::is_always_lock_free && std::atomic<bool>::is_always_lock_free &&
                std::atomic<double>::is_always_lock_free);

  static void store(shared_currents& to, const currents& values) noexcept {
    for (std::size_t i = 0; i < values.size(); ++i) to[i].store(values[i], std::memory_order_relaxed);
  }
  static currents load(const shared_currents& from) noexcept {
    currents values;
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = from[i].load(std::memory_order_relaxed);
    return values;
  }

  void watch(parent_link parent) noexcept {
    be_quick();
    std::uint32_t last = 0;
    double beaten = monotonic_seconds();
    bool silent = false;
    looked_ = beaten;
    while (!parent.gone_within(silent ? p_.release_interval : p_.look())) {
      const double now = monotonic_seconds();
      const std::uint32_t beats = shared_->beats.load(std::memory_order_acquire);
      if (beats != last || beats == 0) beaten = now;
      last = beats;
      silent = now - beaten > p_.timeout;
      if (silent && !released()) begin(now);
      // A live loop applies the currents of a release itself; 0 A is safe from both
      if (released() && !silent) release_.attend(now);
      if (released() && (silent || release_.is_at_once())) give(now);
      else learn(now);
      shared_->looks.fetch_add(1, std::memory_order_relaxed);
    }
    if (!shared_->dismissed.load(std::memory_order_acquire)) {
      double now = monotonic_seconds();
      const bool ended = released() && release_.over(now);  // and not rearmed since
      if (!silent && !ended) begin(now);
      for (; !release_.over(now); now = monotonic_seconds()) {
        give(now);
        // On failure, currents are repeated more often, but not for longer
        poll(nullptr, 0, static_cast<int>(1e3 * p_.release_interval));
      }
    }
    port_.release();
  }

  void begin(double now) noexcept {
    release_.begin({now, load(shared_->flowing)});
    store(shared_->from, release_.start().flowing);
    shared_->began.store(now, std::memory_order_relaxed);
    shared_->released.store(true, std::memory_order_release);
  }

  // Applies the release policy within the coil limits
  void give(double now) noexcept {
    if (release_.over(now)) port_.release();
    else port_.write(limiter_(release_(now), now - looked_));
    looked_ = now;
  }
  // Tracks coil heating by the loop's currents
  void learn(double now) noexcept {
    limiter_(load(shared_->flowing), now - looked_);
    looked_ = now;
  }

  // Failures only delay the supervisor and are not reported; see sched_getscheduler(pid())
  void be_quick() noexcept {
    mlockall(MCL_CURRENT | MCL_FUTURE);
    if (p_.priority == 0) return;
    sched_param priority{};
    priority.sched_priority = p_.priority;
    sched_setscheduler(0, SCHED_FIFO, &priority);
  }

  Port port_;
  supervisor_parameters p_;
  release_profile<brake_count> release_;
  current_limiter<brake_count> limiter_;
  shared_memory<heart> shared_;
  child_process child_;
  double looked_ = 0;                                       // last check of the supervisor [s]
  std::uint32_t looks_ = 0;                                 // as seen by the loop
  double seen_ = -std::numeric_limits<double>::infinity();  // [s]
  bool alive_ = false;
};

}  // namespace passive_haptics
