/// Brake torques of minimum power for desired normal forces.
#pragma once

#include <passive_haptics/control/laws/velocity/torque_range.hpp>
#include <passive_haptics/core/linear/least_squares_by_priority.hpp>
#include <passive_haptics/core/nth.hpp>
#include <passive_haptics/force/torques/torque_units.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace passive_haptics {

/// Increases magnitudes t of rotating brakes while brake i is held: n . xdd = (g_j - g_i A_ij / A_ii) t_j.
template <class T, int Brakes>
void beside_held(const vector<T, Brakes>& g, T missing, const torque_range<T, Brakes>& range,
                 vector<T, Brakes>& t) {
  if (!range.any_at_rest) return;
  for (int i = 0; i < Brakes; ++i) {
    if (!range.held[i] || !(range.sign[i] * g[i] > T(0)) || !(t[i] > T(0))) continue;
    for (int j = 0; j < Brakes; ++j) {
      const T gain = range.sign[j] * (g[j] - g[i] * range.A(i, j) / range.A(i, i));
      if (range.at_rest[j] || !(gain > T(0)) || !(missing > T(0))) continue;
      const T added = std::min(missing / gain, range.upper[j] - t[j]);
      t[j] += added;
      missing -= gain * added;
    }
    return;
  }
}

/// Magnitudes [N m] of brake torques for one wall with g . t at least `wanted` [m/s^2], or the maximum, and
/// minimum dissipated power sum |w_i| |t_i|, and so minimum drag. Brakes are filled in the order of power per
/// acceleration (the fractional knapsack problem of Dantzig 1957); those that only help while the handle
/// lands come last.
template <class T, int Brakes>
vector<T, Brakes> min_power_torques(const vector<T, Brakes>& g, T wanted,
                                    const torque_range<T, Brakes>& range, const vector<T, Brakes>& w) {
  vector<T, Brakes> t = range.lower;
  const vector<T, Brakes> gain = range.sign.cwiseProduct(g);
  T missing = wanted - gain.dot(t);
  const auto comes_before = [&](int i, int j) {
    if (range.sign_is_lasting[i] != range.sign_is_lasting[j]) return range.sign_is_lasting[i];
    return std::abs(w[i]) * gain[j] < std::abs(w[j]) * gain[i];
  };
  for (int round = 0; round < Brakes && missing > T(0); ++round) {
    int best = -1;
    for (int i = 0; i < Brakes; ++i) {
      if (gain[i] > T(0) && t[i] < range.upper[i] && (best < 0 || comes_before(i, best))) best = i;
    }
    if (best < 0) {
      beside_held(g, missing, range, t);
      break;
    }
    const T room = range.upper[best] - t[best], needed = missing / gain[best];
    if (needed <= room) {
      t[best] += needed;
      break;
    }
    t[best] = range.upper[best];
    missing -= room * gain[best];
  }
  return t;
}

/// Torques for several walls: least squares of the force errors [N], then minimum power, then, among brakes
/// at rest, least |t / u|. Walls without a demand are included because the forces are coupled. rows: Lambda_j
/// g_j. u: units from form_of<M>::units. Cost: core/linear/least_squares_by_priority.hpp, two levels.
template <class T, int Brakes, int Walls, class Units = equal_units>
vector<T, Brakes> min_power_torques(const matrix<T, Walls, Brakes>& rows, const vector<T, Walls>& wanted,
                                    const torque_range<T, Brakes>& range, const vector<T, Brakes>& w,
                                    const Units& u = Units()) {
  const vector<T, Brakes> one = range.sign.cwiseProduct(range.lower),
                          other = range.sign.cwiseProduct(range.upper);
  const vector<T, Brakes> per_torque = passive_haptics::parts_per_torque<T, Brakes>(u);
  const T least = T(1e-3) * w.cwiseAbs().cwiseQuotient(per_torque).maxCoeff() + rounding_tolerance<T>(Brakes);
  const matrix<T, Brakes, Brakes> power = (w.cwiseAbs() + least * per_torque).asDiagonal();
  return range.sign.cwiseProduct(least_squares_by_priority(
      vector<T, Brakes>(one.cwiseMin(other)), vector<T, Brakes>(one.cwiseMax(other)),
      least_squares_level{rows, wanted}, least_squares_level{power}));
}

/// Torques for the first `count` walls, each with its `force` [N] and response `along` the normal
/// (acceleration_display.hpp). With several walls, none holds a leaving handle: a force < 0 counts as 0.
template <class Wall, std::size_t Capacity, class T, int Brakes, class Units = equal_units>
vector<T, Brakes> min_power_torques(const std::array<Wall, Capacity>& walls, int count,
                                    const torque_range<T, Brakes>& range, const vector<T, Brakes>& w,
                                    const Units& u = Units()) {
  if (Capacity == 1 || count == 1)
    return min_power_torques<T, Brakes>(walls[0].along.g, walls[0].force / walls[0].along.inertia, range, w);
  if constexpr (Capacity > 1) {
    constexpr int capacity = static_cast<int>(Capacity);
    matrix<T, capacity, Brakes> rows = matrix<T, capacity, Brakes>::Zero();
    vector<T, capacity> wanted = vector<T, capacity>::Zero();
    for (int j = 0; j < count; ++j) {
      const Wall& wall = nth(walls, j);
      set_row<T>(rows, j, wall.along.inertia * wall.along.g);
      wanted[j] = std::max(wall.force, T(0));
    }
    if ((wanted.array() > T(0)).any())
      return min_power_torques<T, Brakes, capacity>(rows, wanted, range, w, u);
  }
  return range.lower;
}

}  // namespace passive_haptics
