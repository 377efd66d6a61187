/// @file
/// Unit vectors for gradients, also where a gradient does not exist.
#pragma once

#include <passive_haptics/scene/shape.hpp>

namespace passive_haptics::detail {

/// r / |r| without over- or underflow; `otherwise` if r = 0.
template <int D>
point<D> direction_or(const point<D>& r, const point<D>& otherwise) {
  const double largest = r.cwiseAbs().maxCoeff();
  if (largest == 0) return otherwise;
  const point<D> scaled = r / largest;
  return scaled / scaled.norm();
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
