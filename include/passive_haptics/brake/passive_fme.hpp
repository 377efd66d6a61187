/// Passive force manipulability ellipsoids (FMEs): the forces a set of brakes can produce (Figs. 2 and 3).
#pragma once

#include <passive_haptics/brake/brake_jacobian.hpp>
#include <passive_haptics/core/nth.hpp>

#include <array>

namespace passive_haptics {

/// Torque signs (-1 or 1) of m brakes in one passive FME.
template <int Brakes>
using torque_signs = std::array<int, std::size_t(Brakes)>;

/// Torque signs of the 2^m passive FMEs. For two brakes (+,+), (+,-) (the paper's FME 2), (-,+), (-,-).
template <int Brakes>
constexpr std::array<torque_signs<Brakes>, (1u << Brakes)> passive_fme_regions() {
  std::array<torque_signs<Brakes>, (1u << Brakes)> regions{};
  for (std::size_t k = 0; k < regions.size(); ++k) {
    for (std::size_t i = 0; i < Brakes; ++i) regions[k][i] = (k >> (Brakes - 1 - i)) & 1u ? -1 : 1;
  }
  return regions;
}

/// Torque signs -s that brakes with rates of signs s can produce. s must not contain zeros.
template <class T, int Brakes>
constexpr torque_signs<Brakes> producible_signs(const vector<T, Brakes>& s) {
  torque_signs<Brakes> signs{};
  for (int i = 0; i < Brakes; ++i) nth(signs, i) = s[i] > T(0) ? -1 : 1;
  return signs;
}

namespace detail {
template <class T, int Brakes>
bool has_signs(const vector<T, Brakes>& t, const torque_signs<Brakes>& signs) {
  bool all = true;
  for (int i = 0; i < Brakes; ++i) all &= static_cast<T>(nth(signs, i)) * t[i] >= T(0);
  return all;
}
}  // namespace detail

/// True if F [N] is in the closed passive FME { F : |t| <= 1 N m, t_i of the region's sign }, t = E^T F.
template <class EMatrix, class T, int D, std::size_t Brakes>
bool in_passive_fme(const EMatrix& E, const std::array<int, Brakes>& region, const vector<T, D>& F) {
  const vector<T, static_cast<int>(Brakes)> t = brake_torque(E, F);
  return t.norm() <= T(1) && detail::has_signs<T, static_cast<int>(Brakes)>(t, region);
}

/// True if F [N] is within torque limits [N m]: t_i has the region's sign and |t_i| <= limit_i.
template <class EMatrix, class T, int D, std::size_t Brakes>
bool in_torque_box(const EMatrix& E, const std::array<int, Brakes>& region, const vector<T, D>& F,
                   const vector<T, static_cast<int>(Brakes)>& limit) {
  const vector<T, static_cast<int>(Brakes)> t = brake_torque(E, F);
  return (t.cwiseAbs().array() <= limit.array()).all() &&
         detail::has_signs<T, static_cast<int>(Brakes)>(t, region);
}

}  // namespace passive_haptics
