/// @file
/// A shape with wall and free space swapped.
#pragma once

#include <passive_haptics/scene/shape.hpp>

#include <utility>

namespace passive_haptics {

/// distance(x) = -S(x): a solid becomes a hollow. Exact where S is. One contact at most; in a hollow with
/// corners that is the nearest face alone, see room.hpp.
template <class S>
class complement {
  static_assert(Shape<S>, "passive_haptics: a complement needs a Shape (scene/shape.hpp).");

 public:
  static constexpr int dimension = S::dimension;  ///< d

  /// Everything outside the shape.
  explicit complement(S shape) : shape_(std::move(shape)) {}

  /// Signed distance [m]; that of the shape, negated.
  double distance(const point<dimension>& x) const { return -shape_.distance(x); }

  /// Gradient of the shape, negated.
  point<dimension> gradient(const point<dimension>& x) const { return -shape_.gradient(x); }

  /// Velocity of the shape [m/s].
  point<dimension> velocity(const point<dimension>& x) const
    requires MovingShape<S>
  {
    return shape_.velocity(x);
  }

  /// Hessian of the shape, negated [1/m].
  matrix<double, dimension, dimension> hessian(const point<dimension>& x) const
    requires CurvedShape<S>
  {
    return matrix<double, dimension, dimension>(-shape_.hessian(x));
  }
  /// The shape itself, to move it.
  S& shape() { return shape_; }

 private:
  S shape_;
};

/// complement(complement(s)) is the complement of a complement, not a copy.
template <class S>
complement(complement<S>) -> complement<complement<S>>;

}  // namespace passive_haptics
