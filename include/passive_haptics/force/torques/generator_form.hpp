/// @file
/// Force approximation in generator form.
#pragma once

#include <passive_haptics/force/approximation.hpp>
#include <passive_haptics/force/torques/nearest_torque.hpp>
#include <passive_haptics/force/torques/torque_units.hpp>

#include <algorithm>
#include <type_traits>

namespace passive_haptics {

/// Fc for a unit desired force n in generator form, F = G t, for redundant brakes and for devices with
/// self-motion: exact where n is in the cone, the torques those of the least |t|.
template <class T, int D, int Brakes>
approximated_force<T, D, Brakes> approximate_by_generators(const matrix<T, D, Brakes>& G,
                                                           const vector<T, Brakes>& s, const vector<T, D>& n,
                                                           T min_cosine) {
  const auto nearest = nearest_torque(G, s, n);
  const T square = nearest.force.squaredNorm(), least = std::max(min_cosine, rounding_tolerance<T>(D));
  if (!(square >= least * least)) return {};
  // What is left of n, against the size of the terms that were added up where F is their sum
  T rounding = rounding_tolerance<T>(D + Brakes);
  if constexpr (D > 3) rounding *= T(1) + size_of_terms(G, nearest.torque);
  if ((n - nearest.force).norm() <= rounding) return {display_class::exact, n, nearest.torque, T(1)};
  return {display_class::approximate, nearest.force / square, nearest.torque / square, square};
}

/// Fc with the torques of the least |t / u|, u being units from torque_units_of. A brake whose unit is 0 is
/// off; its torque is 0 exactly.
template <class T, int D, int Brakes, class Units>
approximated_force<T, D, Brakes> approximate_by_generators(const matrix<T, D, Brakes>& G,
                                                           const vector<T, Brakes>& s, const vector<T, D>& n,
                                                           T min_cosine, const Units& u) {
  if constexpr (std::is_same_v<Units, equal_units>) {
    return approximate_by_generators(G, s, n, min_cosine);
  } else {
    auto F = approximate_by_generators(matrix<T, D, Brakes>(G * u.asDiagonal()), s, n, min_cosine);
    F.torque = F.torque.cwiseProduct(u);
    return F;
  }
}

}  // namespace passive_haptics
