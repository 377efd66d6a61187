/// @file
/// Constants of velocity_direct_control.
#pragma once

#include <passive_haptics/core/parameters.hpp>

#include <algorithm>

namespace passive_haptics {

/// Constants of velocity_direct_control, tuned in simulation on random devices (docs/results.md).
struct velocity_direct_control_parameters {
  double depth_gain = 20;          ///< k_d [1/s]: velocity for each metre that the depth is off.
  double velocity_limit = 0.1;     ///< v_max of the reference velocity [m/s].
  double velocity_lag = 0.0075;    ///< tau_v [s], in which the normal velocity would reach its reference.
  double integral_time = 0.1;      ///< tau_i [s] of the bias.
  double release_length = 160e-6;  ///< l_r [m], of leaving too fast, on which a brake that sticks is let go.
  double hand_mass = 0.4;          ///< m_h [kg], that the hand may add to the device's inertia.
  double force_share = 0.22;       ///< phi [1] of the measured hand force, fed forward.
  double rate_lag = 0.004;         ///< Low-pass of the joint rates, behind that of the encoders [s].
  double horizon = 0.005;          ///< eta [s], over which the brakes' lag is inverted.
  double rest_depth = 2e-3;        ///< d_0, at which the handle shall rest [m];
  double depth_per_jump = 4.5;  ///< or this many times what the depth jumps by a count of the encoders [1].
  double approach_speed = 0.1;  ///< Of a hand that comes to a wall [m/s]: it gives the margin; 0: none.

  static constexpr double jump_time = 2;          ///< In which a jump of the depth is forgotten [s].
  static constexpr double max_rest_depth = 5e-3;  ///< d_ref at most, for the sake of jumps [m].

  /// How far off a wall its contact is needed [m], with brakes of this lag [s].
  constexpr double margin(double lag) const { return approach_speed * (1 / depth_gain + 3 * lag); }
  /// tau_v [s] with brakes of this lag [s]: longer for slow ones, which would overshoot.
  constexpr double velocity_lag_for(double lag) const {
    return std::max(velocity_lag, std::min(0.3 * lag, 0.0125));
  }

  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = velocity_direct_control_parameters;
    return member_table(member("depth_gain", &p::depth_gain, "1/s", range::positive),
                        member("velocity_limit", &p::velocity_limit, "m/s", range::positive),
                        member("velocity_lag", &p::velocity_lag, "s", range::positive),
                        member("integral_time", &p::integral_time, "s", range::positive),
                        member("release_length", &p::release_length, "m", range::positive),
                        member("hand_mass", &p::hand_mass, "kg", range::not_negative),
                        member("force_share", &p::force_share, "1", range::between(0, 1)),
                        member("rate_lag", &p::rate_lag, "s", range::not_negative),
                        member("horizon", &p::horizon, "s", range::not_negative),
                        member("rest_depth", &p::rest_depth, "m", range::not_negative),
                        member("depth_per_jump", &p::depth_per_jump, "1", range::not_negative),
                        member("approach_speed", &p::approach_speed, "m/s", range::not_negative));
  }
};

}  // namespace passive_haptics
