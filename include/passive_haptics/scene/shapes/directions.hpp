/// @file
/// Unit vectors for gradients, also where a gradient does not exist, and their derivative.
#pragma once

#include <passive_haptics/scene/shape.hpp>

#include <cmath>

namespace passive_haptics::detail {

/// r / |r| without over- or underflow; `otherwise` if r = 0.
template <int D>
point<D> direction_or(const point<D>& r, const point<D>& otherwise) {
  const double largest = r.cwiseAbs().maxCoeff();
  if (largest == 0) return otherwise;
  const point<D> scaled = r / largest;
  return scaled / scaled.norm();
}

/// Hessian of the length |P x| at r = P r, where P is a projection [1/m]: (P - r r^T / |r|^2) / |r|; zero
/// where r = 0.
template <int D>
matrix<double, D, D> hessian_of_length(const point<D>& r, const matrix<double, D, D>& P) {
  const double square = r.squaredNorm();
  if (!(square > 0)) return matrix<double, D, D>::Zero();
  return 1 / std::sqrt(square) * (P - r * r.transpose() / square);
}

/// A unit vector at right angles to the unit vector or zero `axis`; the x axis for zero.
template <int D>
point<D> any_perpendicular(const point<D>& axis) {
  int across = 0;
  axis.cwiseAbs().minCoeff(&across);
  const point<D> unit = point<D>::Unit(across);
  return (unit - axis.dot(unit) * axis).normalized();
}

}  // namespace passive_haptics::detail
