/// Unit vectors and derivatives for gradients.
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

/// Hessian of |P x| at r = P r for a projection P [1/m]: (P - r r^T / |r|^2) / |r|; zero if r = 0.
template <int D>
matrix<double, D, D> hessian_of_length(const point<D>& r, const matrix<double, D, D>& P) {
  const double square = r.squaredNorm();
  if (!(square > 0)) return matrix<double, D, D>::Zero();
  return 1 / std::sqrt(square) * (P - r * r.transpose() / square);
}

/// A unit vector perpendicular to the unit vector `axis`; the x axis for a zero vector.
template <int D>
point<D> any_perpendicular(const point<D>& axis) {
  int across = 0;
  axis.cwiseAbs().minCoeff(&across);
  const point<D> unit = point<D>::Unit(across);
  return (unit - axis.dot(unit) * axis).normalized();
}

}  // namespace passive_haptics::detail
