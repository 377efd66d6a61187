/// @file
/// Force approximation in generator form.
#pragma once

#include <passive_haptics/force/approximation.hpp>
#include <passive_haptics/force/torques/nearest_torque.hpp>

#include <algorithm>

namespace passive_haptics {

/// Fc for a unit desired force n in generator form, F = G t, for redundant brakes and for devices with
/// self-motion: exact where n is in the cone, the torques those of least norm. within: the brakes' signs, or
/// their box without bounds (unbounded_torque_box_of) where some are off.
template <class T, int D, int Brakes, class Within>
approximated_force<T, D, Brakes> approximate_by_generators(const matrix<T, D, Brakes>& G,
                                                           const Within& within, const vector<T, D>& n,
                                                           T min_cosine) {
  const auto nearest = nearest_torque(G, within, n);
  const T square = nearest.force.squaredNorm(), least = std::max(min_cosine, rounding_tolerance<T>(D));
  if (!(square >= least * least)) return {};
  // What is left of n, against the size of the terms that were added up where F is their sum
  T rounding = rounding_tolerance<T>(D + Brakes);
  if constexpr (D > 3) rounding *= T(1) + (G.cwiseAbs() * nearest.torque.cwiseAbs()).norm();
  if ((n - nearest.force).norm() <= rounding) return {display_class::exact, n, nearest.torque, T(1)};
  return {display_class::approximate, nearest.force / square, nearest.torque / square, square};
}

}  // namespace passive_haptics
