/// Parameters and states of a safe_port.
#pragma once

#include <passive_haptics/driver/checks/current_limiter.hpp>
#include <passive_haptics/driver/checks/encoder_check.hpp>
#include <passive_haptics/driver/checks/sensor_check.hpp>
#include <passive_haptics/driver/release_policy.hpp>

namespace passive_haptics {

/// Parameters of safe_port.
template <int Brakes, int Channels>
struct safe_port_parameters {
  encoder_limits encoders = {};          ///< Limits of the encoders.
  sensor_limits<Channels> sensor = {};   ///< Limits of the force sensor.
  current_limits<Brakes> currents = {};  ///< Limits of the currents.
  release_parameters at_release = {};    ///< Release policy.
  double hold_over = 0.020;              ///< Maximum time to bridge bad samples or rejected writes [s].
  double period = 0;  ///< Period of read() [s], within which no counter may wrap undetected; 0: measured.

  static constexpr auto members() {
    using p = safe_port_parameters;
    return member_table(member("encoders", &p::encoders), member("sensor", &p::sensor),
                        member("currents", &p::currents), member("at_release", &p::at_release),
                        member("hold_over", &p::hold_over, "s", range::positive).suspicious_above(10),
                        member("period", &p::period, "s", range::not_negative).suspicious_above(1));
  }
};

/// States of a safe_port.
enum class port_state {
  closed,    ///< Not open.
  ready,     ///< Samples are read; 0 A until activate().
  active,    ///< Commanded currents, within limits.
  degraded,  ///< Active with the last good sample, or with a coil too warm for the command.
  released,  ///< After a fault: currents of the release policy until rearm().
};

/// Text of a state.
constexpr std::string_view to_string(port_state s) {
  return detail::word_of(s, {"closed", "ready", "active", "degraded", "released", "unknown state"});
}

}  // namespace passive_haptics
