/// @file
/// Ctrl-C and its like, as a flag that a loop looks at.
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

/// The signals that a loop looks at. While it lives, SIGINT, SIGTERM and SIGHUP do not end the program but
/// set a flag, and SIGUSR1 another. One at a time.
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
  /// Whether SIGUSR1 came since the brakes were first seen released; to be called once a cycle, with whether
  /// they are. A request that came before is dropped: whoever sent it had another release in mind, or none.
  /// So is one that waited while the program was stopped, as the program learns of a release after it goes
  /// on.
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
