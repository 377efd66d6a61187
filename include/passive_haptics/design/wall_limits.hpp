/// The wall calculator: depth, stiffness and drift of a wall rendered by brakes.
#pragma once

#include <passive_haptics/control/laws/velocity/velocity_direct_control_parameters.hpp>
#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/core/scalar/first_order_lag.hpp>

#include <algorithm>
#include <limits>

namespace passive_haptics {

/// A wall at one place of a device, the approaching hand, and the control, along the wall's normal.
/// braked_wall_at() determines the first seven members from a mechanism.
struct braked_wall {
  double force = 10;              ///< F, maximum outward force of the brakes [N].
  double approximated_force = 8;  ///< Its maximum under force approximation, max_approximated_force [N].
  double residual_force = 0;      ///< R, additional force of the residual torques [N]; < 0 pulls the hand in.
  /// Outward force of the residual torques while the handle slides along the wall [N].
  double sliding_residual = 0;
  double inertia = 0.7;            ///< Lambda_n of the device with the hand [kg].
  double depth_resolution = 1e-4;  ///< Maximum change of depth per encoder count [m].
  double approach_speed = 0.1;     ///< v at the surface, into the wall [m/s].

  double time_constant = 0.020;  ///< T_b of the slowest brake's rise [s].
  double push = 2;               ///< P, push of the hand at the surface [N].
  double hand_stiffness = 0;     ///< Decrease of the push with depth [N/m].
  double hand_damping = 20;      ///< Decrease of the push with speed [N s/m]; 20 as following_hand.

  double control_period = 1e-3;  ///< [s]
  double scene_period = 1e-3;    ///< Between two samples of the scene [s].
  /// Additional delay of the law [s]: for velocity_direct_control its low-pass of the rates.
  double reaction_time = velocity_direct_control_parameters().rate_lag;
  /// Averaging time of rates [s]: the window of a difference, or twice the time constant of a low-pass.
  /// Default: encoder_parameters (50 Hz) and velocity_direct_control.
  double averaging_time = 2 * (low_pass_time_constant(50.0) + velocity_direct_control_parameters().rate_lag);
  double rest_depth = velocity_direct_control_parameters().rest_depth;  ///< d_0 of the law [m].
  /// Multiple of depth_resolution that replaces it for coarse encoders [1].
  double depth_per_jump = velocity_direct_control_parameters().depth_per_jump;

  static constexpr const char* type_name = "a braked_wall";  ///< In errors.
  static constexpr auto members() {
    using p = braked_wall;
    return member_table(member("force", &p::force, "N", range::not_negative),
                        member("approximated_force", &p::approximated_force, "N", range::not_negative),
                        member("residual_force", &p::residual_force, "N", range::finite),
                        member("sliding_residual", &p::sliding_residual, "N", range::finite),
                        member("inertia", &p::inertia, "kg", range::positive),
                        member("depth_resolution", &p::depth_resolution, "m", range::not_negative),
                        member("approach_speed", &p::approach_speed, "m/s", range::not_negative),
                        member("time_constant", &p::time_constant, "s", range::not_negative),
                        member("push", &p::push, "N", range::finite),
                        member("hand_stiffness", &p::hand_stiffness, "N/m", range::not_negative),
                        member("hand_damping", &p::hand_damping, "N s/m", range::not_negative),
                        member("control_period", &p::control_period, "s", range::positive),
                        member("scene_period", &p::scene_period, "s", range::not_negative),
                        member("reaction_time", &p::reaction_time, "s", range::not_negative),
                        member("averaging_time", &p::averaging_time, "s", range::positive),
                        member("rest_depth", &p::rest_depth, "m", range::not_negative),
                        member("depth_per_jump", &p::depth_per_jump, "1", range::not_negative));
  }
};

/// Limits of a wall rendered by brakes.
struct wall_limits {
  /// Minimum depth that can be held under velocity_direct_control, if the wall is first seen at the touch
  /// [m]. Infinite if the brakes do not stop the hand within a second and max_landing_depth.
  double depth;
  double rigid_depth;  ///< Maximum depth under force approximation, for any stiffness [m].
  /// Maximum useful stiffness under force approximation [N/m], at which the hand gets half as deep again as
  /// into a rigid wall. 0 if the brakes cannot hold the hand, infinite if it does not enter the wall.
  double stiffness;
  /// Minimum noticeable drift [m/s], at which the ripple of its measured rate equals the rate.
  double drift;
  bool pushed_out;  ///< The residual torques push out a sliding hand without current, with at least its push.

  /// The brakes stop the hand.
  bool holds() const { return depth < std::numeric_limits<double>::infinity(); }
};

/// Maximum depth at which a hand counts as held [m].
inline constexpr double max_landing_depth = 0.05;

namespace detail {

// Depth of the hand [m] if the force rises from `delay` [s] after the touch; infinite if it does not stop:
// Lambda_n x'' = P - K x - B x' - R - f,  T_b f' + f = F
inline double landing_depth(const braked_wall& wall, double force, double delay) {
  constexpr double dt = 1e-5, longest = 1;  // [s]
  double x = 0, v = wall.approach_speed, f = 0;
  for (double t = 0; t < longest && x < max_landing_depth; t += dt) {
    if (t >= delay) f = lagged(f, force, dt, wall.time_constant);
    const double into = wall.push - wall.hand_stiffness * x - wall.residual_force - f;
    // Implicit damping, stable for any value
    const double next = (wall.inertia * v + dt * into) / (wall.inertia + dt * wall.hand_damping);
    x += dt * (v + next) / 2;
    v = next;
    if (!(v > 0)) return std::max(x, 0.0);
  }
  return std::numeric_limits<double>::infinity();
}

// Steady-state depth under velocity_direct_control [m].
inline double resting_depth(const braked_wall& wall) {
  return std::max(wall.rest_depth, std::min(wall.depth_per_jump * wall.depth_resolution,
                                            velocity_direct_control_parameters::max_rest_depth));
}

}  // namespace detail

/// Returns the limits of this wall. docs/guide/design.md has bands over random devices and omitted
/// effects.
///
/// **Depth.** From T after the touch of a stiff wall full torque is commanded. The hand comes to rest at
///
///     Lambda_n x'' = P - K_h x - B_h x' - R - f,    T_b f' + f = F,    f = 0 until T,
///
/// but under velocity_direct_control at least at the law's own depth (rest_depth, depth_per_jump). T is half
/// a period of the control, or of a slower scene, plus the reaction_time. Without hand force, and for brakes
/// that are fast (T_b -> 0) or slow compared with the landing, the depth is
///
///     v T + Lambda_n v^2 / (2 F)    or    v T + 2/3 v sqrt(2 Lambda_n v T_b / F).
///
/// **Stiffness.** A wall of stiffness k demands F at the depth F / k; at k = F / rigid_depth full torque is
/// commanded before the maximum depth is reached.
///
/// **Drift.** A drift v produces a count c every c / v seconds. While such pulses, averaged over T_a, are
/// separate, their variance is v c / T_a - v^2 (Campbell's theorem), which is v^2 at v = c / (2 T_a).
///
/// Throws std::invalid_argument with the text of validate(wall), or if finite values overflow. Depths solve
/// the equation to 0.1 % and 1 um, in up to 200 000 steps.
inline wall_limits limits_of(const braked_wall& wall) {
  require_valid(wall);
  const double late = std::max(wall.control_period, wall.scene_period) / 2;
  const auto landing_depth = [&](double force, double delay) {
    const double depth = detail::landing_depth(wall, force, delay);
    detail::refuse_unless(depth >= 0, "depth of the landing at a braked_wall [m]", depth,
                          "a number: give forces in N and the inertia in kg, so that none of them overflows");
    return depth;
  };
  const double held = landing_depth(wall.force, late + wall.reaction_time);
  const double rigid = landing_depth(wall.approximated_force, late);
  const double stiffness = wall.approximated_force > 0 ? wall.approximated_force / rigid : 0;
  return {std::max(held, detail::resting_depth(wall)), rigid, stiffness,
          wall.depth_resolution / (2 * wall.averaging_time),
          wall.sliding_residual > 0 && wall.sliding_residual >= wall.push};
}

}  // namespace passive_haptics
