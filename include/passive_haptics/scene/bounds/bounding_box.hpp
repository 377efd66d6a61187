/// Axis-aligned bounding boxes.
#pragma once

#include <passive_haptics/scene/shape.hpp>

#include <limits>

namespace passive_haptics {

/// All points x with lower <= x <= upper [m], base frame. Empty by default.
template <int D>
struct bounding_box {
  point<D> lower = point<D>::Constant(std::numeric_limits<double>::infinity());   ///< [m]
  point<D> upper = point<D>::Constant(-std::numeric_limits<double>::infinity());  ///< [m]

  void extend(const point<D>& x) { extend(bounding_box{x, x}); }  ///< Extends the box to contain x.
  /// Extends the box to contain another box.
  void extend(const bounding_box& other) {
    lower = lower.cwiseMin(other.lower);
    upper = upper.cwiseMax(other.upper);
  }
  /// Returns the box with each face moved out by r [m].
  bounding_box grown(double r) const { return {lower.array() - r, upper.array() + r}; }
};

/// Returns the box of half-width r [m] about x.
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
/// Returns the maximum |x_i| over the points of a box that is not empty [m].
template <int D>
double max_coordinate(const bounding_box<D>& b) {
  return b.lower.cwiseAbs().cwiseMax(b.upper.cwiseAbs()).maxCoeff();
}
}  // namespace detail

/// A shape that provides the extent of its wall. Minimal complete definition, in addition to Shape:
///   - `bounding_box<dimension> bounds() const`: contains every point of the wall (distance <= 0); may be
///     infinite.
/// Law: distance(x) is at least the distance from x to the box.
template <class S>
concept BoundedShape = Shape<S> && requires(const S shape) {
  { shape.bounds() } -> std::same_as<bounding_box<S::dimension>>;
};

}  // namespace passive_haptics
