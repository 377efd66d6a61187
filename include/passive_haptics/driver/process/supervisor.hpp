/// @file
/// A second process that releases the brakes when the loop's process cannot.
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

/// How long a supervisor waits.
struct supervisor_parameters {
  double timeout = 0.010;  ///< Without a heartbeat for so long, the brakes are released [s].
  int priority = 0;        ///< SCHED_FIFO priority of its process, over the loop's; 0 for none.

  /// From one look to the next [s]: it looks four times in a timeout.
  double look() const noexcept { return timeout / 4; }
  /// How long after the last heartbeat it acts at the latest [s], if it is woken at most `wake_up` [s] late:
  /// one look until it notices that heartbeat, and four until the timeout is over.
  double latest(double wake_up = 0) const noexcept { return 5 * (look() + wake_up); }
  /// How long it may not be seen by the loop before it counts as lost [s].
  double lost() const noexcept { return std::max(0.1, timeout); }
  /// From one current of a release to the next [s].
  static constexpr double release_interval = 2e-3;

  static constexpr const char* type_name = "the supervisor";  ///< In errors.
  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = supervisor_parameters;
    return member_table(member("timeout", &p::timeout, "s", range::between(0.004, 10)),
                        member("priority", &p::priority, "", range::between(0, 99).as("0 (none) to 99")));
  }
};

/// Analog outputs keep their last value when a process dies. A supervisor is a process with a port of its own
/// to the same device; it releases the brakes, as the release policy says, when the loop's process dies
/// (their pipe closes) or its heartbeat stops for `timeout`, as of SIGSTOP or a cycle that hangs. It looks
/// four times in that time, so it is never later than 1.25 timeouts if it gets the processor; and it goes on
/// until rearm(). Where the loop does not come back it gives 0 A after release_parameters::max_duration().
/// Where loop and supervisor are both dead, or stopped, the device's own watchdog is what is left.
///
/// Start it before the loop's real-time set-up and before any thread.
template <class Port>
class supervisor {
  static_assert(is_port<Port, explain>());
  static_assert(
      !requires { typename Port::port_type; },
      "passive_haptics: a supervisor may wait, so it takes the port itself: threaded_port::port_type");

 public:
  static constexpr int brake_count = Port::brake_count;  ///< Brakes.
  using currents = brake_currents<brake_count>;          ///< [A]

  /// The port must not be open. The release policy and the limits of the currents are the safe_port's. Throws
  /// std::invalid_argument with the text of validate() of what is wrong.
  explicit supervisor(Port port, const supervisor_parameters& p = {},
                      const release_parameters& at_release = {},
                      const current_limits<brake_count>& limits = {})
      : port_(std::move(port)), p_(require_valid(p)), release_(at_release), limiter_(limits) {}

  /// Forks the process, which opens its port; empty, or why it could not.
  std::string start() {
    return child_.start([this] { return port_.open(); }, [this](parent_link parent) { watch(parent); });
  }

  /// The heartbeat, once a cycle, with its time [s, CLOCK_MONOTONIC] and what flows [A]; the first one starts
  /// the watch. If a current is NaN, what flows is unknown (safe_port::applied()): then it is no heartbeat.
  /// False where the supervisor released the brakes, or has not been seen for 0.1 s, or for `timeout` where
  /// that is longer: release them here, too, from where it began().
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

  /// Whether it was there at the last beat: nothing is to be rearmed without it.
  bool alive() const noexcept { return alive_; }

  /// Whether it released the brakes.
  bool released() const noexcept { return shared_->released.load(std::memory_order_acquire); }
  /// Where it began to, so that the loop goes on from there; none where it did not.
  std::optional<release_start<brake_count>> began() const noexcept {
    if (!released()) return {};
    return release_start<brake_count>{shared_->began.load(std::memory_order_relaxed), load(shared_->from)};
  }
  /// Lets the loop's currents flow again.
  void rearm() noexcept { shared_->released.store(false, std::memory_order_release); }
  /// Ends it, after the loop released the brakes: it gives 0 A once more. It takes two seconds at most, and a
  /// third where it must be killed.
  void stop() noexcept {
    shared_->dismissed.store(true, std::memory_order_release);
    child_.stop(2);
  }
  /// Its process number; <= 0 if it does not run.
  pid_t pid() const noexcept { return child_.pid(); }

 private:
  using shared_currents = std::array<std::atomic<double>, static_cast<std::size_t>(brake_count)>;
  struct heart {
    std::atomic<std::uint32_t> beats = 0, looks = 0;
    std::atomic<bool> released = false, dismissed = false;
    shared_currents flowing{}, from{};  // what the loop gives, and what flowed when the release began [A]
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
      // A loop that beats gives the currents of a release itself; of 0 A nothing else can be said
      if (released() && !silent) release_.attend(now);
      if (released() && (silent || release_.is_at_once())) give(now);
      else learn(now);
      shared_->looks.fetch_add(1, std::memory_order_relaxed);
    }
    if (!shared_->dismissed.load(std::memory_order_acquire)) {
      double now = monotonic_seconds();
      const bool ended = released() && release_.over(now);  // and nobody rearmed since
      if (!silent && !ended) begin(now);
      for (; !release_.over(now); now = monotonic_seconds()) {
        give(now);
        // If that fails, currents are given more often, and no longer
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

  // What the release policy says, as far as the coils bear it
  void give(double now) noexcept {
    if (release_.over(now)) port_.release();
    else port_.write(limiter_(release_(now), now - looked_));
    looked_ = now;
  }
  // How warm the coils get by the loop's currents
  void learn(double now) noexcept {
    limiter_(load(shared_->flowing), now - looked_);
    looked_ = now;
  }

  // A refusal changes nothing but how soon the supervisor acts, which still releases: so it is not reported,
  // and sched_getscheduler(pid()) says what was granted
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
  double looked_ = 0;                                       // the supervisor, before [s]
  std::uint32_t looks_ = 0;                                 // as the loop saw them
  double seen_ = -std::numeric_limits<double>::infinity();  // [s]
  bool alive_ = false;
};

}  // namespace passive_haptics
