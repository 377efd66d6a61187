/// Ctrl-C and similar signals as flags for a loop.
#pragma once

#include <array>
#include <atomic>
#include <csignal>

namespace passive_haptics {
namespace detail {
inline std::atomic<int> signal_to_stop = 0;
inline std::atomic<bool> signal_to_rearm = false;
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);
}  // namespace detail

/// Signals as flags: during its lifetime, SIGINT, SIGTERM and SIGHUP set a flag instead of ending the
/// program, and SIGUSR1 sets another. Only one instance at a time.
class stop_signals {
 public:
  stop_signals() {
    detail::signal_to_stop = 0;
    detail::signal_to_rearm = false;
    struct sigaction act = {};
    sigemptyset(&act.sa_mask);
    for (std::size_t i = 0; i < caught.size(); ++i) {
      act.sa_handler = caught[i] == SIGUSR1 ? +[](int) { detail::signal_to_rearm = true; }
                                            : +[](int signal) { detail::signal_to_stop = signal; };
      sigaction(caught[i], &act, &before_[i]);
    }
  }
  stop_signals(const stop_signals&) = delete;
  stop_signals& operator=(const stop_signals&) = delete;
  ~stop_signals() {
    for (std::size_t i = 0; i < caught.size(); ++i) sigaction(caught[i], &before_[i], nullptr);
  }

  /// The last signal to stop; 0 if there was none.
  int stop() const noexcept { return detail::signal_to_stop; }
  /// True if SIGUSR1 arrived since the brakes were first seen released. Call it once per cycle with their
  /// state. Earlier requests are dropped, since they meant another release.
  bool rearm(bool released) noexcept {
    const bool came = detail::signal_to_rearm.exchange(false);
    const bool counts = came && released && were_released_;
    were_released_ = released && !counts;
    return counts;
  }

 private:
  bool were_released_ = false;
  static constexpr std::array<int, 4> caught{SIGINT, SIGTERM, SIGHUP, SIGUSR1};
  std::array<struct sigaction, 4> before_{};
};

}  // namespace passive_haptics
