/// A shape with wall and free space swapped.
#pragma once

#include <passive_haptics/scene/shapes/shape_wrapper.hpp>

#include <utility>

namespace passive_haptics {

/// distance(x) = -S(x), which turns a solid into a hollow. Reports the contact of the nearest face only; use
/// walls_of if all faces of a corner must be felt.
template <class S>
class complement : public shape_wrapper<S> {
 public:
  using shape_wrapper<S>::dimension;  ///< d

  explicit complement(S shape) : shape_wrapper<S>(std::move(shape)) {}  ///< Everything outside the shape.

  /// Signed distance [m].
  double distance(const point<dimension>& x) const { return -this->shape_.distance(x); }

  /// Gradient of the shape, negated.
  point<dimension> gradient(const point<dimension>& x) const { return -this->shape_.gradient(x); }

  static constexpr double thickness() { return std::numeric_limits<double>::infinity(); }  ///< Infinite.

  /// Hessian of the shape, negated [1/m].
  matrix<double, dimension, dimension> hessian(const point<dimension>& x) const
    requires CurvedShape<S>
  {
    return -this->shape_.hessian(x);
  }
};

/// complement(complement(s)) wraps twice instead of copying.
template <class S>
complement(complement<S>) -> complement<complement<S>>;

}  // namespace passive_haptics
