/// @file
/// In which units the torques of least norm are least: parts of what each brake can make.
///
/// Where several sets of torques make the same force, those of the least |t / t_max| are taken, t_max_i being
/// the most that brake i can make with its sign. So N and N m are not added, and a strong brake takes the
/// greater part: a force grows further before the first limit is reached.
///
///     t = u y, the least |y|, u_i = t_max_i / (the largest t_max)
///
/// A brake with t_max_i = 0 is off, u_i = 0; of others u_i is at least 1e-8 (1e-4 in float), so that rounding
/// loses no column of G u. Where some t_max is infinite, u_i = 1 for all brakes that are on, and where no
/// limit is named, for all: the least |t|. Equal limits give u_i = 1 exactly, and so the same torques to the
/// bit.
#pragma once

#include <passive_haptics/core/linear/elimination.hpp>
#include <passive_haptics/force/torques/nearest_torque.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace passive_haptics {

/// In place of a vector of units: 1 for each brake.
struct equal_units {};

/// u (m) of the largest magnitudes t_max [N m], >= 0, that brakes can make.
template <class T, int Brakes>
vector<T, Brakes> torque_units(const vector<T, Brakes>& t_max) {
  constexpr T least = std::numeric_limits<T>::digits > 30 ? T(1e-8) : T(1e-4);
  const T largest = t_max.maxCoeff();
  vector<T, Brakes> u;
  unrolled<Brakes>([&](auto i) {
    const T part = std::isinf(largest) ? T(1) : std::max(t_max[i] / largest, least);
    u[i] = t_max[i] > T(0) ? part : T(0);
  });
  return u;
}

/// 1 / u (m), which turns torques into the parts y; 1 for a brake that is off, which cannot move.
template <class T, int Brakes, class Units>
vector<T, Brakes> parts_per_torque([[maybe_unused]] const Units& u) {
  if constexpr (std::is_same_v<Units, equal_units>) return vector<T, Brakes>::Ones();
  else return (u.array() > T(0)).select(u.cwiseInverse(), T(1));
}

/// The last of several levels, whatever is left: the least |y| of t = u y.
template <class T, int Brakes, class Units>
auto min_torque_level([[maybe_unused]] const Units& u) {
  if constexpr (std::is_same_v<Units, equal_units>) {
    return least_squares_level{identity_matrix<T, Brakes>()};
  } else {
    return least_squares_level{
        matrix<T, Brakes, Brakes>(passive_haptics::parts_per_torque<T, Brakes>(u).asDiagonal())};
  }
}
/// The least |y - y_0|, t_0 = u y_0.
template <class T, int Brakes, class Units>
auto min_torque_level(const Units& u, const vector<T, Brakes>& t_0) {
  auto level = passive_haptics::min_torque_level<T, Brakes>(u);
  level.b = level.A * t_0;
  return level;
}

}  // namespace passive_haptics
