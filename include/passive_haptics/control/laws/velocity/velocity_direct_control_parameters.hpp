/// Constants of velocity_direct_control.
#pragma once

#include <passive_haptics/core/parameters.hpp>

#include <algorithm>

namespace passive_haptics {

/// Constants of velocity_direct_control, tuned in simulation on random devices (docs/results.md).
struct velocity_direct_control_parameters {
  double depth_gain = 20;          ///< k_d [1/s]: velocity per depth error.
  double velocity_limit = 0.1;     ///< v_max of the reference velocity [m/s].
  double velocity_lag = 0.0075;    ///< tau_v [s], time constant of the normal velocity.
  double integral_time = 0.1;      ///< tau_i [s] of the bias.
  double release_length = 160e-6;  ///< l_r [m], outward motion in which a sticking brake is released.
  double hand_mass = 0.4;          ///< m_h [kg], mass of the hand in addition to the device.
  double force_share = 0.22;       ///< phi [1], feedforward share of the measured hand force.
  double rate_lag = 0.004;         ///< Low-pass of the joint rates, after that of the encoders [s].
  double horizon = 0.005;          ///< eta [s], horizon of the lag inversion.
  double rest_depth = 2e-3;        ///< d_0, steady-state depth [m].
  double depth_per_jump = 4.5;     ///< Steady-state depth per jump of the depth by an encoder count [1].
  double approach_speed = 0.1;  ///< Of a hand that approaches a wall [m/s]; determines the margin; 0: none.

  static constexpr double jump_time = 2;          ///< Decay time of the maximum jump [s].
  static constexpr double max_rest_depth = 5e-3;  ///< Maximum of d_ref for jumps [m].

  /// Distance from a wall at which its contact is needed [m], for a brake lag [s].
  constexpr double margin(double lag) const { return approach_speed * (1 / depth_gain + 3 * lag); }
  /// tau_v [s] for a brake lag [s]: longer for slow brakes, to avoid overshoot.
  constexpr double velocity_lag_for(double lag) const {
    return std::max(velocity_lag, std::min(0.3 * lag, 0.0125));
  }

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
