/// @file
/// A shape with wall and free space swapped.
#pragma once

#include <passive_haptics/scene/shapes/shape_wrapper.hpp>

#include <utility>

namespace passive_haptics {

/// distance(x) = -S(x): a solid becomes a hollow. Exact where S is. One contact at most: in a corner only
/// that of the nearest face. Give each face as a wall to feel all of them (walls_of).
template <class S>
class complement : public shape_wrapper<S> {
 public:
  using shape_wrapper<S>::dimension;  ///< d

  /// Everything outside the shape.
  explicit complement(S shape) : shape_wrapper<S>(std::move(shape)) {}

  /// Signed distance [m]; that of the shape, negated.
  double distance(const point<dimension>& x) const { return -this->shape_.distance(x); }

  /// Gradient of the shape, negated.
  point<dimension> gradient(const point<dimension>& x) const { return -this->shape_.gradient(x); }

  /// Infinite: what surrounds a hollow has one side.
  static constexpr double thickness() { return std::numeric_limits<double>::infinity(); }

  /// Hessian of the shape, negated [1/m].
  matrix<double, dimension, dimension> hessian(const point<dimension>& x) const
    requires CurvedShape<S>
  {
    return -this->shape_.hessian(x);
  }
};

/// complement(complement(s)) is the complement of a complement, not a copy.
template <class S>
complement(complement<S>) -> complement<complement<S>>;

}  // namespace passive_haptics
