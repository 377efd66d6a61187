/// @file
/// A braked wall's numbers from a mechanism in a pose.
#pragma once

#include <passive_haptics/brake/models/encoder_axes.hpp>
#include <passive_haptics/brake/models/switchable_brakes.hpp>
#include <passive_haptics/control/laws/velocity/acceleration_display.hpp>
#include <passive_haptics/design/displayable.hpp>
#include <passive_haptics/design/max_resistance.hpp>
#include <passive_haptics/design/wall_limits.hpp>

#include <algorithm>
#include <cmath>

namespace passive_haptics {

/// One count of each encoder of mechanism M [rad, or m of a slide]; see encoder_axes.
template <class M>
using encoder_resolution = vector<typename M::scalar, encoder_axes<M>::count>;

/// What the residual torques [N m] push a handle along the normal n, of any length > 0, with [N] that slides
/// with a velocity along the wall: n . F of F = -G s t_r (4), as long as nothing accelerates. 0 for a handle
/// that rests.
template <Dynamics M>
typename M::scalar sliding_residual(const M& mechanism, const joint_vector<M>& q,
                                    const task_vector<M>& velocity, const task_vector<M>& normal,
                                    const brake_vector<M>& residual_torque) {
  const task_vector<M> n = direction_of(normal);
  const task_vector<M> along = detail::along_wall(velocity, n);
  const auto found = displayable(mechanism, q, along, n);
  const brake_vector<M> t = found.signs.cwiseProduct(residual_torque);
  return -n.dot(form_of<M>::force_in_motion(mechanism_pose<M>(mechanism, q), t, found.held));
}

/// The wall of normal n (base frame, out of the wall, any length > 0) that these brakes can make at joint
/// positions q, touched with `velocity` [m/s]; a hand of this mass [kg] moves with the handle, the encoders
/// have this resolution.
///
/// The motion decides which way each brake can push, and it changes while the handle lands. Its mean is
/// taken: all of the velocity along the wall and half of it into the wall. The forces are 0 where nothing can
/// be displayed (displayable). Where the handle cannot move along n, or n is 0 or not finite, the inertia is
/// not finite, which limits_of refuses.
///
/// Time, rates and the hand's forces are left at their defaults. Cost: a displayable and some solutions with
/// the mass matrix.
template <Dynamics M>
braked_wall braked_wall_at(const M& mechanism, const joint_vector<M>& q, const task_vector<M>& velocity,
                           const task_vector<M>& normal, const switchable_brakes<M>& brakes,
                           const brake_vector<M>& residual_torque, const encoder_resolution<M>& resolution,
                           typename M::scalar hand_mass) {
  using T = typename M::scalar;
  const task_vector<M> n = direction_of(normal);
  const T outward = n.dot(velocity);
  const auto found = displayable(mechanism, q, task_vector<M>(velocity - outward / 2 * n), n, brakes);
  const pose_dynamics<M> device({mechanism, q}, joint_vector<M>::Zero(), hand_mass);
  const auto along = response_along(n, device, task_vector<M>::Zero().eval());
  const encoder_axes<M> axes(mechanism);

  braked_wall wall;
  wall.force = static_cast<double>(found.max_force);
  wall.approximated_force = static_cast<double>(found.max_approximated_force);
  wall.residual_force -=
      static_cast<double>(along.inertia * along.g.dot(found.signs.cwiseProduct(residual_torque)));
  wall.sliding_residual =
      static_cast<double>(passive_haptics::sliding_residual(mechanism, q, velocity, n, residual_torque));
  wall.inertia = static_cast<double>(along.inertia);
  wall.approach_speed = std::max(0.0, -static_cast<double>(outward));
  wall.time_constant = static_cast<double>(brakes.time_constant.maxCoeff());
  wall.depth_resolution = 0;
  for (int i = 0; i < encoder_axes<M>::count; ++i) {
    const joint_vector<M> one = axes.to_joints(encoder_resolution<M>::Unit(i));
    wall.depth_resolution =
        std::max(wall.depth_resolution, static_cast<double>(resolution[i] * std::abs(n.dot(device.J * one))));
  }
  return wall;
}

}  // namespace passive_haptics
