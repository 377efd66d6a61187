/// @file
/// What brakes get once they are released.
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/driver/port.hpp>

#include <algorithm>

namespace passive_haptics {

/// How a release ends the currents.
enum class release_policy {
  zero,  ///< 0 A at once: the handle is free.
  ramp,  ///< Down to 0 A within ramp_time: an arm under gravity sinks instead of falling.
  hold,  ///< The last currents stay: for brakes that current opens, or an arm that must not sink. Heat may
         ///< lower them.
};

/// A policy and its time.
struct release_parameters {
  release_policy policy = release_policy::zero;  ///< How.
  double ramp_time = 0.5;                        ///< Of a ramp [s].

  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = release_parameters;
    return member_table(
        choice("policy", &p::policy, "zero, ramp, hold"),
        member("ramp_time", &p::ramp_time, "s", range::positive, plausible(0.001, 10)).large_over(60));
  }
};

/// Currents from a release on.
template <int N>
class release_profile {
 public:
  /// Throws std::invalid_argument with the text of validate(p).
  explicit release_profile(const release_parameters& p) : p_(require_valid(p)) {}

  /// A release begins while these flow [A].
  void begin(const brake_currents<N>& flowing) noexcept {
    from_ = flowing;
    left_ = p_.policy == release_policy::zero ? 0 : 1;
  }

  /// What may still flow `dt` [s] later [A].
  brake_currents<N> operator()(double dt) noexcept {
    if (p_.policy == release_policy::ramp) left_ = std::max(0.0, left_ - dt / p_.ramp_time);
    brake_currents<N> now{};
    for (std::size_t i = 0; i < now.size(); ++i) now[i] = left_ * from_[i];
    return now;
  }

  /// Whether nothing flows any more at once.
  bool is_at_once() const noexcept { return p_.policy == release_policy::zero; }

 private:
  release_parameters p_;
  brake_currents<N> from_{};
  double left_ = 0;  // share of from_
};

}  // namespace passive_haptics
