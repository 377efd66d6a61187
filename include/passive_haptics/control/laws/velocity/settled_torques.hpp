/// Brake torques for desired normal forces with a settled self-motion (n > d).
#pragma once

#include <passive_haptics/brake/at_rest/settled_rates.hpp>
#include <passive_haptics/brake/signs.hpp>
#include <passive_haptics/control/cycle_inputs.hpp>
#include <passive_haptics/control/laws/velocity/acceleration_display.hpp>
#include <passive_haptics/force/forms/form_of.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace passive_haptics {

/// Torques, and the normal force of each wall.
template <class T, int Brakes, int Capacity>
struct settled_torques {
  using each_wall = std::array<T, static_cast<std::size_t>(Capacity)>;  ///< One number per wall.

  vector<T, Brakes> capacity = vector<T, Brakes>::Zero();  ///< [N m]
  each_wall made = {};                                     ///< Normal forces n_j . F [N].
  each_wall max_force = {};                                ///< Their maximum values [N].
  bool sticks = true;  ///< None of the pushing brakes rotates, except those that come to rest.
};

/// Torques for demands n_j . F = force_j >= 0, with signs settled at the velocity v' `landed` [m/s], or at v
/// `now` if those display less. Cost: a nearest force, for several walls a contact_forces.
template <Settles M, int Capacity, class Device, class T, int D>
settled_torques<T, M::brake_count, Capacity> settled_torques_at(
    const Device& device, const vector<T, D>& landed, const vector<T, D>& now,
    const std::array<contact_demand<T, D>, static_cast<std::size_t>(Capacity)>& demands, int count,
    approximation_start& start) {
  constexpr int m = M::brake_count;
  settled_torques<T, m, Capacity> all;
  brake_set held;
  if (count == 1) {
    const auto unit =
        form_of<M>::nearest(device, landed, now, demands[0].normal, device.options.min_cosine, start.held);
    held = unit.held;
    const vector<T, m> bound = passive_haptics::torque_bounds_of(device.brakes, unit.torque);
    const auto max_force =
        (unit.torque.array() != T(0))
            .select(bound.array() / unit.torque.array().abs(), std::numeric_limits<T>::infinity());
    all.max_force[0] = is_displayed(unit.display) ? max_force.minCoeff() : T(0);
    all.made[0] = std::min(demands[0].force, all.max_force[0]);
    all.capacity = all.made[0] * unit.torque.cwiseAbs();
    if (device.options.limits == saturation::clamp_each)
      for (int i = 0; i < m; ++i)  // keeps NaN
        all.capacity[i] = std::min(demands[0].force * std::abs(unit.torque[i]), bound[i]);
  } else {
    const auto settled =
        form_of<M>::template signs_at<Capacity>(device, landed, now, demands, count, start.held);
    held = settled.held;
    const auto map = form_of<M>::map(device.pose, device.E);
    const auto box = passive_haptics::torque_box_of(settled.signs, device.brakes);
    const auto met = contact_forces<T, D, m, Capacity>(map, box, demands, count);
    const vector<T, m> limit = passive_haptics::max_torques_of<T, m>(device.brakes);
    all.capacity = met.torque.cwiseAbs();
    all.made = met.displayed;
    for (int j = 0; j < count; ++j) {
      const auto k = static_cast<std::size_t>(j);
      for (int i = 0; i < m; ++i)
        if (const T gain = std::abs(demands[k].normal.dot(map.G.col(i))); gain > T(0))
          all.max_force[k] += gain * limit[i];
    }
  }
  for (int i = 0; i < m; ++i)
    if (!contains(held, i) && all.capacity[i] > T(0) &&
        slips(device.w[i], passive_haptics::rate_dead_band_of<T>(device.brakes, i)))
      all.sticks = false;
  return all;
}

/// Normal force [N] that keeps a handle at rest against the hand force Fh and gravity. `along` includes a
/// share of Fh.
template <class T, int D, int Brakes>
T holding_force(const normal_response<T, D, Brakes>& along, const vector<T, D>& Fh, T share) {
  return -along.normal.dot(Fh) - along.inertia * (along.free - along.per_newton.dot(share * Fh));
}

/// Torques for walls of velocity_direct_control, with a response `along` the normal, a demanded `force` [N],
/// and speeds. The handle should move with v', once it has the normal velocities that the walls demand and
/// follows the hand along them. At rest, each wall gets at most twice the holding force, so that a pulling
/// hand is free even if the wall has learned a larger one. The same applies to a moving handle if two of the
/// `near_walls` are closed, or if it leaves a wall near another one; a wall then also gets its stopping
/// force, because the sensor does not detect a coasting hand. The first `count` walls demand a force.
template <Settles M, class Device, class Wall, std::size_t Capacity, class T = typename M::scalar>
auto settled_torques_for(const Device& device, const pose_dynamics<M>& dynamics,
                         const std::array<Wall, Capacity>& walls, int near_walls, int count, T force_share,
                         approximation_start& start) {
  constexpr int m = M::brake_count, sweeps = 4;
  constexpr T max_held(2);
  bool rests = true;
  for (int i = 0; i < m; ++i)
    rests = rests && !slips(dynamics.rates[i], passive_haptics::rate_dead_band_of<T>(device.brakes, i));
  const auto closed = std::count_if(walls.begin(), walls.begin() + near_walls,
                                    [](const Wall& wall) { return wall.is_closed(); });
  std::array<contact_demand<T, M::task_dimension>, Capacity> demands;
  for (std::size_t j = 0; j < std::size_t(count); ++j) {
    const auto& along = walls[j].along;
    T wanted = std::max(walls[j].force, T(0));
    if (rests || closed > 1 || (near_walls > 1 && walls[j].stop_speed <= T(0))) {
      const T holding = passive_haptics::holding_force(along, device.hand_force, force_share),
              stopping = rests ? T(0) : walls[j].damping * std::max(walls[j].stop_speed, T(0));
      wanted = std::min(wanted, std::max(max_held * holding, T(0)) + stopping);
    }
    demands[j] = {along.normal, wanted, false};
  }
  task_vector<M> gained = task_vector<M>::Zero(), follows = device.hand_force;
  for (int sweep = 0; sweep < (count > 1 ? sweeps : 1); ++sweep) {
    for (std::size_t j = 0; j < std::size_t(count); ++j) {
      const task_vector<M>& n = walls[j].along.normal;
      gained += (std::min(walls[j].speed_error, walls[j].stop_speed) - n.dot(gained)) * n;
      follows -= n.dot(follows) * n;
    }
  }
  const task_vector<M> landed = dynamics.velocity + gained + T(form_of<M>::mobility) * follows;
  return passive_haptics::settled_torques_at<M, static_cast<int>(Capacity)>(device, landed, dynamics.velocity,
                                                                            demands, count, start);
}

}  // namespace passive_haptics
