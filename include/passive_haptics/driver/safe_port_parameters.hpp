/// @file
/// What a safe_port allows, and how it can be.
#pragma once

#include <passive_haptics/driver/checks/current_limiter.hpp>
#include <passive_haptics/driver/checks/encoder_check.hpp>
#include <passive_haptics/driver/checks/sensor_check.hpp>
#include <passive_haptics/driver/release_policy.hpp>

namespace passive_haptics {

/// What a safe_port allows.
template <int Brakes, int Channels>
struct safe_port_parameters {
  encoder_limits encoders = {};          ///< What the encoders can do.
  sensor_limits<Channels> sensor = {};   ///< What the force sensor can report.
  current_limits<Brakes> currents = {};  ///< What the brakes may get.
  release_parameters at_release = {};    ///< What they get once they are released.
  /// How long the last good sample stands in for bad ones, or for refused writes [s].
  double hold_over = 0.020;
  /// Period of the loop that calls read() [s], within which no counter may wrap unseen; 0: it is measured.
  double period = 0;

  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = safe_port_parameters;
    return member_table(member("encoders", &p::encoders), member("sensor", &p::sensor),
                        member("currents", &p::currents), member("at_release", &p::at_release),
                        member("hold_over", &p::hold_over, "s", range::positive).suspicious_above(10),
                        member("period", &p::period, "s", range::not_negative).suspicious_above(1));
  }
};

/// How a safe_port is.
enum class port_state {
  closed,    ///< Not open.
  ready,     ///< Samples are read; the brakes get 0 A until activate().
  active,    ///< The brakes get what is commanded, within their limits.
  degraded,  ///< Active, but on the last good sample, or a coil is too warm for what is commanded.
  released,  ///< A fault: the brakes get what the release policy says, by default 0 A, until rearm().
};

/// The state in words.
constexpr std::string_view to_string(port_state s) {
  return detail::word_of(s, {"closed", "ready", "active", "degraded", "released", "unknown state"});
}

}  // namespace passive_haptics
