/// Units of brake torques, for solutions of least norm.
///
/// If several sets of torques produce the same force, the one of least |t / t_max| is selected, where t_max_i
/// is the maximum torque of brake i with its sign. N and N m are not added, and strong brakes carry more.
///
///     t = u y, least |y|, u_i = t_max_i / (maximum of all t_max)
///
/// A brake with t_max_i = 0 is off, u_i = 0. Otherwise u_i >= 1e-8 (1e-4 in float), so that rounding loses no
/// column of G u. If some t_max is infinite or missing, u_i = 1 for all brakes that are on.
#pragma once

#include <passive_haptics/core/linear/elimination.hpp>
#include <passive_haptics/force/torques/nearest_torque.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace passive_haptics {

/// Replaces a vector of units that are all 1.
struct equal_units {};

/// Units u (m) for maximum torques t_max [N m], >= 0.
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

/// 1 / u (m), which converts torques to y; 1 for a brake that is off.
template <class T, int Brakes, class Units>
vector<T, Brakes> parts_per_torque([[maybe_unused]] const Units& u) {
  if constexpr (std::is_same_v<Units, equal_units>) return vector<T, Brakes>::Ones();
  else return (u.array() > T(0)).select(u.cwiseInverse(), T(1));
}

/// Last of several levels: minimises |y|, t = u y.
template <class T, int Brakes, class Units>
auto min_torque_level([[maybe_unused]] const Units& u) {
  if constexpr (std::is_same_v<Units, equal_units>) {
    return least_squares_level{identity_matrix<T, Brakes>()};
  } else {
    return least_squares_level{
        matrix<T, Brakes, Brakes>(passive_haptics::parts_per_torque<T, Brakes>(u).asDiagonal())};
  }
}
/// Minimises |y - y_0|, t_0 = u y_0.
template <class T, int Brakes, class Units>
auto min_torque_level(const Units& u, const vector<T, Brakes>& t_0) {
  auto level = passive_haptics::min_torque_level<T, Brakes>(u);
  level.b = level.A * t_0;
  return level;
}

}  // namespace passive_haptics
