/// The braked_wall of a mechanism in a pose.
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

/// One count of each encoder of mechanism M [rad or m], see encoder_axes.
template <class M>
using encoder_resolution = vector<typename M::scalar, encoder_axes<M>::count>;

/// Force along the normal n (any length > 0) by the residual torques [N m] on a handle that slides along the
/// wall with `velocity` [N]: n . F with F = -G s t_r (4), without acceleration. 0 for a handle at rest.
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

/// Returns the wall of outward normal n (base frame, any length > 0) that these brakes can render at joint
/// positions q for a touch with `velocity` [m/s]. hand_mass [kg] moves with the handle; resolution is that of
/// the encoders. Time, rates and hand forces keep their defaults.
///
/// The motion determines the sign of each brake and changes during the landing, so its mean is used: the
/// velocity along the wall and half the velocity into it. The forces are 0 if nothing can be displayed. The
/// inertia is not finite, which limits_of rejects, if the handle cannot move along n, or n is 0 or not
/// finite.
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
