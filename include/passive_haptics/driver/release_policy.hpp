/// Currents after a release of the brakes.
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/driver/port.hpp>

#include <algorithm>
#include <cmath>

namespace passive_haptics {

/// Policies of a release.
enum class release_policy {
  zero,  ///< 0 A immediately: the handle is free.
  ramp,  ///< Ramp to 0 A within ramp_time: an arm under gravity sinks instead of falling.
  hold,  ///< Keeps the last currents while the loop runs, and hold_time longer: for brakes that open by
         ///< current, or an arm that must not sink. Heat may lower them; 0 A is final.
};

/// A policy and its times.
struct release_parameters {
  release_policy policy = release_policy::zero;  ///< Policy.
  double ramp_time = 0.5;                        ///< Of a ramp [s].
  double hold_time = 10;                         ///< Of a hold, after rearming has become impossible [s].

  static constexpr auto members() {
    using p = release_parameters;
    return member_table(choice("policy", &p::policy, "zero, ramp, hold"),
                        member("ramp_time", &p::ramp_time, "s", range::positive).suspicious_above(60),
                        member("hold_time", &p::hold_time, "s", range::positive).suspicious_above(600));
  }

  /// Maximum duration of currents after rearming has become impossible [s].
  double max_duration() const noexcept {
    switch (policy) {
      case release_policy::ramp: return ramp_time;
      case release_policy::hold: return hold_time;
      default: return 0;
    }
  }
};

/// Time and currents at the start of a release.
template <int N>
struct release_start {
  double time = 0;              ///< [s]
  brake_currents<N> flowing{};  ///< [A]
};

/// Currents of a release as a function of time, so that two processes with the same start agree.
template <int N>
class release_profile {
 public:
  /// Throws std::invalid_argument with the text of validate(p).
  explicit release_profile(const release_parameters& p) : p_(require_valid(p)) {}

  /// Starts a release.
  void begin(const release_start<N>& start) noexcept {
    start_ = start;
    attended_ = start.time;
  }
  /// Continues a release that another process began, unless the currents have ended.
  void take_over(const release_start<N>& start) noexcept {
    if (start_.flowing != brake_currents<N>{} && start_.time != start.time) begin(start);
  }
  /// Reports that the loop runs: a hold lasts hold_time from now. A release that is over stays so.
  void attend(double now) noexcept {
    if (over(now)) start_.flowing = {};
    attended_ = now;
  }
  const release_start<N>& start() const noexcept { return start_; }  ///< Start of the release.

  /// Currents at a time [A]. A ramp gives 0 A for NaN and for times far before its start.
  brake_currents<N> operator()(double now) const noexcept {
    double share = over(now) ? 0 : 1;
    if (share > 0 && p_.policy == release_policy::ramp)
      share = std::min(1.0, 1 - (now - start_.time) / p_.ramp_time);
    brake_currents<N> flowing = start_.flowing;
    for (double& current : flowing) current *= share;
    return flowing;
  }

  /// True if no current flows any more: the ramp is done, or the loop has not run for hold_time.
  bool over(double now) const noexcept {
    if (start_.flowing == brake_currents<N>{}) return true;
    if (p_.policy == release_policy::hold) return now - attended_ >= p_.hold_time;
    // The other process may have started slightly later
    return !(std::abs(now - start_.time) < p_.max_duration());
  }

  release_policy policy() const noexcept { return p_.policy; }  ///< The policy.

  /// True if the policy ends currents immediately.
  bool is_at_once() const noexcept { return p_.policy == release_policy::zero; }

 private:
  release_parameters p_;
  release_start<N> start_;
  double attended_ = 0;  // last cycle of the loop, for a hold [s]
};

}  // namespace passive_haptics
