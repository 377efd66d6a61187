/// The wall calculator (design/wall_limits.hpp) for mechanisms chosen at run time.
#pragma once

#include <passive_haptics/design/braked_wall_at.hpp>
#include <passive_haptics/runtime/brake_numbers.hpp>
#include <passive_haptics/runtime/cycle_record.hpp>

#include <span>

namespace passive_haptics::runtime {

/// Arguments of passive_haptics::braked_wall_at().
struct wall_touch {
  std::span<const double> q;                ///< n [rad or m]
  std::span<const double> velocity;         ///< d [m/s]
  std::span<const double> normal;           ///< d, outward, any length > 0.
  std::span<const double> residual_torque;  ///< m [N m]
  std::span<const double> resolution;       ///< One count of each encoder [rad or m].
  double hand_mass = 0;                     ///< [kg]
};

/// Compiled once per kind of mechanism with inertia and as many joints as task dimensions. Throws
/// std::invalid_argument for missing numbers.
template <class M>
braked_wall wall_at(const M& mechanism, const brake_numbers& brakes, const wall_touch& touch) {
  require_count("joint positions", std::ssize(touch.q), M::dof);
  require_count("components of the velocity", std::ssize(touch.velocity), M::task_dimension);
  require_count("components of the normal", std::ssize(touch.normal), M::task_dimension);
  require_count("residual torques", std::ssize(touch.residual_torque), M::brake_count);
  require_count("encoder resolutions", std::ssize(touch.resolution), encoder_axes<M>::count);
  require_count("brakes", std::ssize(brakes.torque_limit), M::brake_count);
  return passive_haptics::braked_wall_at(
      mechanism, joint_vector<M>(touch.q.data()), task_vector<M>(touch.velocity.data()),
      task_vector<M>(touch.normal.data()), brakes.as<switchable_brakes<M>>(),
      brake_vector<M>(touch.residual_torque.data()), encoder_resolution<M>(touch.resolution.data()),
      touch.hand_mass);
}

}  // namespace passive_haptics::runtime
