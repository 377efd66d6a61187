/// @file
/// Brake torques that give walls the normal forces they want, of a device whose self-motion settles (n > d).
#pragma once

#include <passive_haptics/brake/settled_rates.hpp>
#include <passive_haptics/brake/signs.hpp>
#include <passive_haptics/control/cycle_inputs.hpp>
#include <passive_haptics/control/ways/one_wall.hpp>
#include <passive_haptics/force/torques/force_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace passive_haptics {

/// Torques, and what each wall gets of them.
template <class T, int Brakes, int Capacity>
struct settled_torques {
  using each_wall = std::array<T, static_cast<std::size_t>(Capacity)>;  ///< One for each wall.

  vector<T, Brakes> capacity = vector<T, Brakes>::Zero();  ///< [N m]
  each_wall made = {};                                     ///< Normal forces n_j . F [N],
  each_wall largest = {};                                  ///< and what they could be at most [N].
  bool sticks = true;  ///< None of the brakes that push turns, but for those that come to rest anyway.
};

/// The torques for walls whose demands want n_j . F = force_j >= 0, by the signs of brakes that have settled
/// at the velocity v' `landed` [m/s]; of one wall at the velocity v `now`, where those display nothing. One
/// wall gets force_j by the nearest force, several by contact_forces. Cost: display_form, and for several
/// walls a contact_forces.
template <Settles M, int Capacity, class Device, class T, int D>
settled_torques<T, M::brake_count, Capacity> settled_torques_for(
    const Device& device, const vector<T, D>& landed, const vector<T, D>& now,
    const std::array<contact_demand<T, D>, static_cast<std::size_t>(Capacity)>& demands, int count,
    approximation_start& start) {
  constexpr int m = M::brake_count;
  const vector<T, m> limit = passive_haptics::torque_limits_of<T, m>(device.brakes);
  settled_torques<T, m, Capacity> all;
  brake_set held;
  if (count == 1) {
    const auto unit = display_form<M>::nearest_at(device, landed, now, demands[0].normal,
                                                  step_options<T>().min_cosine, start.held);
    held = unit.held;
    const auto largest =
        (unit.torque.array() != T(0))
            .select(limit.array() / unit.torque.array().abs(), std::numeric_limits<T>::infinity());
    all.largest[0] = is_displayed(unit.display) ? largest.minCoeff() : T(0);
    all.made[0] = std::min(demands[0].force, all.largest[0]);
    all.capacity = all.made[0] * unit.torque.cwiseAbs();
  } else {
    const auto settled =
        display_form<M>::template signs_at<Capacity>(device, landed, demands, count, start.held);
    held = settled.held;
    const auto map = passive_haptics::force_map_of(device.pose, device.E);
    const auto met =
        contact_forces<T, D, m, Capacity>(map, torques_within(settled.signs, limit), demands, count);
    all.capacity = met.torque.cwiseAbs();
    all.made = met.displayed;
    for (int j = 0; j < count; ++j) {
      const auto k = static_cast<std::size_t>(j);
      for (int i = 0; i < m; ++i)
        if (const T gain = std::abs(demands[k].normal.dot(map.G.col(i))); gain > T(0))
          all.largest[k] += gain * limit[i];
    }
  }
  for (int i = 0; i < m; ++i)
    if (!contains(held, i) && all.capacity[i] > T(0) &&
        slips(device.w[i], passive_haptics::rate_dead_band_of<T>(device.brakes, i)))
      all.sticks = false;
  return all;
}

}  // namespace passive_haptics
