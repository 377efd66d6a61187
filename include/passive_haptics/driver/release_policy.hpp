/// @file
/// What brakes get once they are released.
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/driver/port.hpp>

#include <algorithm>
#include <cmath>

namespace passive_haptics {

/// How a release ends the currents.
enum class release_policy {
  zero,  ///< 0 A at once: the handle is free.
  ramp,  ///< Down to 0 A within ramp_time: an arm under gravity sinks instead of falling.
  hold,  ///< The last currents stay, for brakes that current opens, or an arm that must not sink: while the
         ///< loop runs, and hold_time longer. Heat may lower them. What came to 0 A stays there.
};

/// A policy and its time.
struct release_parameters {
  release_policy policy = release_policy::zero;  ///< How.
  double ramp_time = 0.5;                        ///< Of a ramp [s].
  double hold_time = 10;  ///< Of a hold once nobody can rearm: the program had to end, or died [s].

  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = release_parameters;
    return member_table(choice("policy", &p::policy, "zero, ramp, hold"),
                        member("ramp_time", &p::ramp_time, "s", range::positive).suspicious_above(60),
                        member("hold_time", &p::hold_time, "s", range::positive).suspicious_above(600));
  }

  /// How long current may flow once nobody can rearm any more [s].
  double max_duration() const noexcept {
    switch (policy) {
      case release_policy::ramp: return ramp_time;
      case release_policy::hold: return hold_time;
      default: return 0;
    }
  }
};

/// When a release began, and what flowed then.
template <int N>
struct release_start {
  double time = 0;              ///< [s]
  brake_currents<N> flowing{};  ///< [A]
};

/// Currents from a release on, by the time alone: two processes that know the same start give the same
/// currents.
template <int N>
class release_profile {
 public:
  /// Throws std::invalid_argument with the text of validate(p).
  explicit release_profile(const release_parameters& p) : p_(require_valid(p)) {}

  /// A release begins.
  void begin(const release_start<N>& start) noexcept {
    start_ = start;
    attended_ = start.time;
  }
  /// The release that another process began goes on here. If nothing flows any more, nothing changes.
  void take_over(const release_start<N>& start) noexcept {
    if (start_.flowing != brake_currents<N>{} && start_.time != start.time) begin(start);
  }
  /// The loop runs at this time, so that somebody can rearm: a hold lasts hold_time from here on. What is
  /// over stays so until the next begin().
  void attend(double now) noexcept {
    if (over(now)) start_.flowing = {};
    attended_ = now;
  }
  /// Where it began.
  const release_start<N>& start() const noexcept { return start_; }

  /// What may flow at a time [A]. A ramp gives 0 A at a time that is none or far before its start.
  brake_currents<N> operator()(double now) const noexcept {
    double share = over(now) ? 0 : 1;
    if (share > 0 && p_.policy == release_policy::ramp)
      share = std::min(1.0, 1 - (now - start_.time) / p_.ramp_time);
    brake_currents<N> flowing = start_.flowing;
    for (double& current : flowing) current *= share;
    return flowing;
  }

  /// Whether nothing flows any more at a time: a ramp is done, or nobody ran the loop for hold_time.
  bool over(double now) const noexcept {
    if (start_.flowing == brake_currents<N>{}) return true;
    if (p_.policy == release_policy::hold) return now - attended_ >= p_.hold_time;
    // Another process may have begun a little later than this one's cycle
    return !(std::abs(now - start_.time) < p_.max_duration());
  }

  /// Whether nothing flows any more at once.
  bool is_at_once() const noexcept { return p_.policy == release_policy::zero; }

 private:
  release_parameters p_;
  release_start<N> start_;
  double attended_ = 0;  // when the loop ran last, for a hold [s]
};

}  // namespace passive_haptics
