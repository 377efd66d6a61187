/// @file
/// Direct control at the level of velocities: the handle neither sinks into a wall nor drifts off it.
#pragma once

#include <passive_haptics/control/control_law.hpp>
#include <passive_haptics/control/laws/acceleration_display.hpp>
#include <passive_haptics/control/laws/brake_lag.hpp>
#include <passive_haptics/control/laws/contact_memory.hpp>
#include <passive_haptics/control/laws/torque_law.hpp>
#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/scene/contacts.hpp>

#include <algorithm>
#include <cmath>

namespace passive_haptics {

/// Constants of velocity_direct_control, tuned in simulation on the paper's device (docs/results.md).
struct velocity_direct_control_parameters {
  double depth_gain = 30;          ///< k_d [1/s]: velocity for each metre that the depth is off.
  double velocity_limit = 0.02;    ///< v_max of the reference velocity [m/s].
  double velocity_lag = 0.010;     ///< tau_v [s], in which the normal velocity reaches its reference.
  double landing_velocity = 0.01;  ///< Sinking slower than this counts as landed [m/s].
  double horizon = 0.005;          ///< eta [s], over which the brakes' lag is inverted.
  /// Depth at which the handle comes to rest, or deeper where it came too fast [m].
  double rest_depth = 1e-3;
  /// By which the scene's walls are grown (scene/shapes/offset.hpp) to be seen beforehand [m].
  double margin = 0;

  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = velocity_direct_control_parameters;
    return member_table(
        member("depth_gain", &p::depth_gain, "1/s", range::positive, plausible(1, 1000)),
        member("velocity_limit", &p::velocity_limit, "m/s", range::positive, plausible(0.001, 1)),
        member("velocity_lag", &p::velocity_lag, "s", range::positive, plausible(0.001, 0.5)),
        member("landing_velocity", &p::landing_velocity, "m/s", range::positive, plausible(1e-4, 1)),
        member("horizon", &p::horizon, "s", range::not_negative, plausible(0, 0.1)),
        member("rest_depth", &p::rest_depth, "m", range::not_negative, plausible(0, 0.02)),
        member("margin", &p::margin, "m", range::not_negative, plausible(0, 0.02)));
  }
};

/// Direct control that keeps the handle at a small depth in each wall, by its normal acceleration:
///
///     a* = -v^T H v + (v_ref - n . v) / tau_v,   v_ref = clip(k_d (depth - d_ref), +-v_max),
///
/// with H the curvature of the wall and d_ref the depth at which the handle landed, rest_depth or more. The
/// brakes add n . G t = a* - n . a_0 to the acceleration a_0 that the handle would have without them, as near
/// as their cone and limits allow and with the least drag, and nothing where they would have to push it in. A
/// brake at rest is known to make no more than what holds it (nearest_torques). Their lag is inverted.
///
/// A handle that comes at 0.1 m/s is over a millimetre deep before lagging brakes hold it. So that they begin
/// before, grow the walls, `wall(offset(shape, margin))`, and give the same margin here: within it only an
/// approach faster than k_d (rest_depth - depth) is braked, and depths count from the shape's own surface. A
/// contact held by a slow virtual environment is carried on to second order from where it was sensed; with a
/// margin it is known in time.
///
/// Needs the hand force, the inertia and the brakes' lag. Cost: a Cholesky of n x n and one prioritised least
/// squares.
class velocity_direct_control {
 public:
  static constexpr bool needs_hand_force = true;  ///< Needs a force sensor at the handle.
  static constexpr bool needs_dynamics = true;    ///< Needs the inertia of the mechanism.
  static constexpr bool needs_brake_lag = true;   ///< Needs the brakes' time constants.
  static constexpr bool commands_torques = true;  ///< It is a TorqueLaw.

  /// Of one wall.
  struct landing {
    bool landed = false;  ///< The handle has come to rest in the wall's normal direction.
    double depth = 0;     ///< There [m].
  };
  /// What it remembers.
  struct memory {
    contact_memory<landing> walls;  ///< Where the handle landed on each.
    brake_lag_model brakes;         ///< What the brakes make.
  };

  /// Throws std::invalid_argument with the text of validate(p).
  explicit velocity_direct_control(const velocity_direct_control_parameters& p = {}) : p_(require_valid(p)) {}

  /// The constants as given.
  const velocity_direct_control_parameters& parameters() const { return p_; }

  /// Brake torques [N m].
  template <class M, class EMatrix, int D, int Capacity, class B>
  brake_vector<M> torque(const brake_situation<M, EMatrix, B>& now, const contacts<D, Capacity>& touched,
                         memory& remembered) const noexcept {
    using T = typename M::scalar;
    const point<D> v = as<double>(now.v);
    wanted_accelerations<T, D, Capacity> wanted;
    remembered.walls.begin_cycle();
    for (const auto& c : touched) {
      const point<D> moved = now.x - c.position, relative = v - c.wall_velocity;
      const point<D> n = (c.normal + c.curvature * moved).normalized();
      const double depth = c.depth - p_.margin - moved.dot(c.normal + 0.5 * (c.curvature * moved));
      wanted.add(as<T>(n), static_cast<T>(wanted_acceleration(depth, n.dot(relative),
                                                              relative.dot(c.curvature * relative),
                                                              remembered.walls.of(c.wall))));
    }
    brake_vector<M> t = nearest_torques(now, wanted);
    remembered.brakes.advance(now.time, now.brakes.time_constant);
    unrolled<M::brake_count>([&](auto i) {
      const T u = remembered.brakes.command(i, std::abs(t[i]), now.brakes.time_constant[i],
                                            torque_limit_of<T>(now.brakes, i), p_.horizon);
      t[i] = std::copysign(u, t[i]);
    });
    return t;
  }

  /// Free space or a fault: the walls are forgotten.
  void released(memory& remembered, double) const noexcept {
    remembered.walls.clear();
    remembered.brakes.release();
  }

 private:
  // a* [m/s^2] at this depth [m] and outward velocity [m/s]; curving = v^T H v [m/s^2]
  double wanted_acceleration(double depth, double outward, double curving, landing& wall) const {
    if (!wall.landed && depth > 0 && outward > -p_.landing_velocity)
      wall = {true, std::max(depth, p_.rest_depth)};
    const double v_max = p_.velocity_limit;
    const double v_ref = wall.landed ? std::clamp(p_.depth_gain * (depth - wall.depth), -v_max, v_max)
                                     : std::min(0.0, p_.depth_gain * (depth - p_.rest_depth));
    return -curving + (v_ref - outward) / p_.velocity_lag;
  }

  velocity_direct_control_parameters p_;
};

}  // namespace passive_haptics
