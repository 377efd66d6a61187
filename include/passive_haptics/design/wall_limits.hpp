/// @file
/// The wall calculator: how stiff, how shallow and how still a wall made of brakes can be.
#pragma once

#include <passive_haptics/control/laws/velocity/velocity_direct_control_parameters.hpp>
#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/core/scalar/first_order_lag.hpp>

#include <algorithm>
#include <limits>

namespace passive_haptics {

/// A wall at one place of a device, the hand that comes, and the control, along the wall's normal.
/// braked_wall_at() takes the first seven from a mechanism.
struct braked_wall {
  double force = 10;  ///< F, the most that the brakes make out of the wall [N].
  double approximated_force =
      8;                      ///< The most that force approximation makes of it, max_approximated_force [N].
  double residual_force = 0;  ///< R, what the residual torques add [N]; < 0 pulls the hand in.
  /// What the residual torques push out with while the handle slides along the wall [N].
  double sliding_residual = 0;
  double inertia = 0.7;            ///< Lambda_n of the device with the hand [kg].
  double depth_resolution = 1e-4;  ///< What the depth changes by at a count of an encoder, at most [m].
  double approach_speed = 0.1;     ///< v at the surface, into the wall [m/s].

  double time_constant = 0.020;  ///< T_b of the slowest brake's rise [s].
  double push = 2;               ///< P of the hand at the surface [N].
  double hand_stiffness = 0;     ///< By which the push falls with the depth [N/m],
  double hand_damping = 20;      ///< and with the speed [N s/m]; 20 is that of following_hand.

  double control_period = 1e-3;  ///< [s]
  double scene_period = 1e-3;    ///< Between two samples of the scene [s].
  /// How late the law acts beyond these [s]: velocity_direct_control by its low-pass of the rates.
  double reaction_time = velocity_direct_control_parameters().rate_lag;
  /// Over which rates are averaged [s]: the window of a difference, or twice the time constant of a low-pass.
  /// Here that of encoder_parameters, 50 Hz, and of velocity_direct_control.
  double averaging_time = 2 * (low_pass_time_constant(50.0) + velocity_direct_control_parameters().rate_lag);
  double rest_depth = velocity_direct_control_parameters().rest_depth;  ///< d_0 of the law [m],
  /// or this many times the depth_resolution [1], where the law has coarse encoders.
  double depth_per_jump = velocity_direct_control_parameters().depth_per_jump;

  static constexpr const char* type_name = "a braked_wall";  ///< In errors.
  /// The table of core/parameters.hpp.
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

/// What a wall made of brakes can be.
struct wall_limits {
  /// Smallest depth that can be held, under velocity_direct_control that sees the wall once it is touched
  /// [m]: how deep the hand gets. Infinite where the brakes do not stop it within a second and
  /// max_landing_depth.
  double depth;
  double rigid_depth;  ///< Largest depth under force approximation, for a wall of any stiffness [m].
  /// Largest useful stiffness under force approximation [N/m]: the hand gets half as deep again as into a
  /// rigid wall. 0 where the brakes cannot hold the hand, infinite where the hand does not get into a wall.
  double stiffness;
  /// Least noticeable drift off the wall or into it [m/s]: the ripple of its measured rate is as large as
  /// itself.
  double drift;
  /// The residual torques alone push out a hand that slides along the wall, with its push or more: here
  /// brakes without current hold it off.
  bool pushed_out;

  /// The brakes stop the hand.
  bool holds() const { return depth < std::numeric_limits<double>::infinity(); }
};

/// The deepest hand that still counts as held [m].
inline constexpr double max_landing_depth = 0.05;

namespace detail {

// How deep the hand gets [m] where all of the force rises from `delay` [s] after the touch; infinite where it
// does not stop:  Lambda_n x'' = P - K x - B x' - R - f,  T_b f' + f = F
inline double landing_depth(const braked_wall& wall, double force, double delay) {
  constexpr double dt = 1e-5, longest = 1;  // [s]
  double x = 0, v = wall.approach_speed, f = 0;
  for (double t = 0; t < longest && x < max_landing_depth; t += dt) {
    if (t >= delay) f = lagged(f, force, dt, wall.time_constant);
    const double into = wall.push - wall.hand_stiffness * x - wall.residual_force - f;
    // The damping at the end of the step, so that none is too strong
    const double next = (wall.inertia * v + dt * into) / (wall.inertia + dt * wall.hand_damping);
    x += dt * (v + next) / 2;
    v = next;
    if (!(v > 0)) return std::max(x, 0.0);
  }
  return std::numeric_limits<double>::infinity();
}

// Where velocity_direct_control lets the hand rest [m]: the depth jumps by a count of the encoders.
inline double resting_depth(const braked_wall& wall) {
  return std::max(wall.rest_depth, std::min(wall.depth_per_jump * wall.depth_resolution,
                                            velocity_direct_control_parameters::max_rest_depth));
}

}  // namespace detail

/// What this wall can be. Bands over random devices, and what is left out: docs/guide/wall_limits.md.
///
/// **Depth.** A stiff wall saturates at once: from T after the touch the command is all that the brakes have.
/// The depth is where the hand then comes to rest,
///
///     Lambda_n x'' = P - K_h x - B_h x' - R - f,    T_b f' + f = F,    f = 0 until T,
///
/// but under velocity_direct_control not less than where the law rests: at its rest_depth, or with coarse
/// encoders at depth_per_jump times the depth_resolution, up to the law's max_rest_depth. T is half a period
/// of the control, or of a slower scene, and the law's reaction_time. With a hand that brings no force, and
/// brakes that are quick (T_b -> 0) or slow beside the landing, it is
///
///     v T + Lambda_n v^2 / (2 F)    or    v T + 2/3 v sqrt(2 Lambda_n v T_b / F).
///
/// **Stiffness.** A wall of stiffness k demands F at the depth F / k. Where that is less than the
/// rigid_depth, all is commanded before the hand is as deep as it gets anyway: k = F / rigid_depth.
///
/// **Drift.** A drift v makes a count c every c / v seconds. While such pulses, averaged over T_a, stand
/// apart, their mean square is v c / T_a (Campbell's theorem), their variance v c / T_a - v^2. That is v^2 at
/// v = c / (2 T_a).
///
/// **Residual torque.** A hand that slides is pushed_out where sliding_residual > 0 is at least P.
///
/// Throws std::invalid_argument with the text of validate(wall), or where finite values overflow, so that a
/// depth is no number. Depths are those of the equation to 0.1 % and 1 um. Cost: twice up to 100 000 steps of
/// ten operations and an exponential.
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
