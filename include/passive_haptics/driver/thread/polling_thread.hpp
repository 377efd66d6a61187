/// @file
/// A thread that looks again and again.
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/driver/clock.hpp>

#include <pthread.h>

#include <atomic>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <string>

namespace passive_haptics {

/// How often a thread looks.
struct polling_parameters {
  double pause = 1e-4;  ///< From one look to the next [s]: a tenth of section 5.1's cycle.

  static constexpr const char* owner = "a polling thread";  ///< In errors.
  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    return member_table(
        member("pause", &polling_parameters::pause, "s", range::between(1e-6, 1), plausible(1e-5, 0.01)));
  }
};

/// Calls look() until it ends. It inherits the scheduling of the thread that starts it (priority, processor);
/// signals go to the others. Not to be moved while it runs.
class polling_thread {
 public:
  /// Throws std::invalid_argument with the text of validate(p).
  explicit polling_thread(const polling_parameters& p) : pause_(std::llround(1e9 * require_valid(p).pause)) {}
  polling_thread(const polling_thread&) = delete;
  polling_thread& operator=(const polling_thread&) = delete;
  ~polling_thread() { stop(); }

  /// Starts it, with a noexcept look.operator()() whose owner lives until stop(); empty, or why it could not.
  template <class Look>
  std::string start(Look& look) {
    look_ = &look;
    call_ = [](void* l) noexcept { (*static_cast<Look*>(l))(); };
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setstacksize(&attributes, stack);
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    const int error = pthread_create(&thread_, &attributes, run, this);
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    pthread_attr_destroy(&attributes);
    runs_ = error == 0;
    return runs_ ? "" : std::string("a port's thread: ").append(std::strerror(error));
  }

  /// Whether it was started and not stopped.
  bool runs() const noexcept { return runs_; }

  /// Ends it: waits for the look under way.
  void stop() noexcept {
    if (!runs_) return;
    ended_.store(true, std::memory_order_relaxed);
    pthread_join(thread_, nullptr);
    runs_ = false;
  }

 private:
  static constexpr std::size_t stack = 1 << 20;  // [bytes]; all of it is locked where memory is

  static void* run(void* self) noexcept {
    polling_thread& t = *static_cast<polling_thread*>(self);
    const monotonic_clock clock;
    while (!t.ended_.load(std::memory_order_relaxed)) {
      t.call_(t.look_);
      clock.sleep_until(clock.now() + t.pause_);
    }
    return nullptr;
  }

  std::int64_t pause_;  // [ns]
  void* look_ = nullptr;
  void (*call_)(void*) noexcept = nullptr;
  pthread_t thread_{};
  bool runs_ = false;
  std::atomic<bool> ended_ = false;
};

}  // namespace passive_haptics
