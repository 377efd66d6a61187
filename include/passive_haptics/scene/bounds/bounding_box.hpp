/// @file
/// The axis-aligned box about a shape.
#pragma once

#include <passive_haptics/scene/shape.hpp>

#include <limits>

namespace passive_haptics {

/// All points x with lower <= x <= upper [m], base frame. By default empty: it grows by what it is extended
/// by.
template <int D>
struct bounding_box {
  point<D> lower = point<D>::Constant(std::numeric_limits<double>::infinity());   ///< [m]
  point<D> upper = point<D>::Constant(-std::numeric_limits<double>::infinity());  ///< [m]

  /// Grows until it holds x, too.
  void extend(const point<D>& x) { extend(bounding_box{x, x}); }
  /// Grows until it holds another box, too.
  void extend(const bounding_box& other) {
    lower = lower.cwiseMin(other.lower);
    upper = upper.cwiseMax(other.upper);
  }
  /// A box with each face moved out by r [m].
  bounding_box grown(double r) const { return {lower.array() - r, upper.array() + r}; }
};

/// The box of half-width r [m] about x.
template <int D>
bounding_box<D> box_about(const point<D>& x, double r) {
  return bounding_box<D>{x, x}.grown(r);
}

/// All of space.
template <int D>
bounding_box<D> everywhere() {
  const point<D> infinity = point<D>::Constant(std::numeric_limits<double>::infinity());
  return {-infinity, infinity};
}

namespace detail {
/// The largest |x_i| of the points of a box that is not empty.
template <int D>
double max_coordinate(const bounding_box<D>& b) {
  return b.lower.cwiseAbs().cwiseMax(b.upper.cwiseAbs()).maxCoeff();
}
}  // namespace detail

/// A shape that provides the extent of its wall. Minimal complete definition, beyond Shape:
///   - `bounding_box<dimension> bounds() const`: holds every point of the wall (distance <= 0); may be
///     infinite.
///
/// Laws: distance(x) is not less than the distance from x to the box.
template <class S>
concept BoundedShape = Shape<S> && requires(const S shape) {
  { shape.bounds() } -> std::same_as<bounding_box<S::dimension>>;
};

}  // namespace passive_haptics
