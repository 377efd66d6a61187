/// Common base of shapes made from another shape.
#pragma once

#include <passive_haptics/scene/shape.hpp>

#include <utility>

namespace passive_haptics {

/// Base of a shape around a shape S. Forwards each optional member of S that the wrapper does not define,
/// except bounds(), which depend on the wrapper.
template <class S>
class shape_wrapper {
  static_assert(Shape<S>, "passive_haptics: the wrapped type must be a Shape (scene/shape.hpp).");

 public:
  static constexpr int dimension = S::dimension;                  ///< d
  static constexpr bool has_unit_gradient = gradient_is_unit<S>;  ///< As the shape.

  /// Gradient of the shape.
  point<dimension> gradient(const point<dimension>& x) const { return shape_.gradient(x); }

  /// Velocity of the shape [m/s].
  point<dimension> velocity(const point<dimension>& x) const
    requires MovingShape<S>
  {
    return shape_.velocity(x);
  }

  /// Hessian of the shape [1/m].
  matrix<double, dimension, dimension> hessian(const point<dimension>& x) const
    requires CurvedShape<S>
  {
    return shape_.hessian(x);
  }

  double thickness() const { return thickness_of(shape_); }  ///< Thickness of the shape [m].

  /// Extrapolates the motion by this time [s].
  void extrapolate(double seconds)
    requires requires(S& s) { s.extrapolate(seconds); }
  {
    shape_.extrapolate(seconds);
  }

  S& shape() { return shape_; }  ///< The wrapped shape.

 protected:
  explicit shape_wrapper(S shape) : shape_(std::move(shape)) {}  ///< Wraps the shape.
  shape_wrapper(const shape_wrapper&) = default;                 ///< Protected, against slicing.
  shape_wrapper& operator=(const shape_wrapper&) = default;      ///< Protected, against slicing.

  S shape_;  ///< The shape.
};

}  // namespace passive_haptics
