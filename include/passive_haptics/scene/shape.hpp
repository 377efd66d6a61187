/// @file
/// The Shape concept: a virtual wall as a signed distance.
#pragma once

#include <passive_haptics/core/matrix.hpp>

#include <concepts>
#include <limits>

namespace passive_haptics {

/// A point or direction of a scene [m]. Distances are always in double, whatever the scalar of the forces:
/// a depth is the difference of nearly equal numbers.
template <int D>
using point = vector<double, D>;

namespace detail {
template <class S>
concept names_dimension = requires { requires(std::integral_constant<int, S::dimension>::value > 0); };
}  // namespace detail

/// A wall's geometry.
///
/// Minimal complete definition:
///   - `static constexpr int dimension`;
///   - `double distance(const point<dimension>& x) const`: signed distance [m], positive in free space;
///   - `point<dimension> gradient(const point<dimension>& x) const`: its gradient, a unit vector out of the
///     wall.
///
/// Laws: |distance(x) - distance(y)| <= |x - y| (1-Lipschitz). gradient is the derivative of distance; where
/// there is none, any unit vector that points to free space. A NaN in x gives a NaN distance, so that no step
/// mistakes it for free space. testing/shape_properties.hpp checks them.
///
/// Optional, in addition to the members of MovingShape, CurvedShape and BoundedShape:
///   - `static constexpr bool has_unit_gradient = true`: the gradient has length 1 by construction. A scene
///     checks each gradient of a shape without it;
///   - `void extrapolate(double seconds)`: carries a moving shape on for this time [s] (moving.hpp);
///   - `double thickness() const`: the smallest distance between two opposite sides [m], for a shape that is
///     thinner than its bounds.
/// A shape that is made of another one keeps them (shape_wrapper.hpp).
template <class S>
concept Shape = detail::names_dimension<S> && requires(const S shape, const point<S::dimension> x) {
  { shape.distance(x) } -> std::same_as<double>;
  { shape.gradient(x) } -> ExactVector<double, S::dimension>;
};

/// Whether a shape says that its gradient has length 1 by construction.
template <class S>
inline constexpr bool gradient_is_unit = requires { requires S::has_unit_gradient; };

/// A shape that moves. Minimal complete definition, beyond Shape:
///   - `point<dimension> velocity(const point<dimension>& x) const`: velocity [m/s] of the surface nearest to
///     x, base frame.
template <class S>
concept MovingShape = Shape<S> && requires(const S shape, const point<S::dimension> x) {
  { shape.velocity(x) } -> ExactVector<double, S::dimension>;
};

/// Velocity [m/s] of the surface of a shape nearest to x; zero for one that does not move.
template <Shape S>
point<S::dimension> surface_velocity(const S& shape, const point<S::dimension>& x) {
  if constexpr (MovingShape<S>) return shape.velocity(x);
  else return point<S::dimension>::Zero();
}

/// A shape that provides its curvature. Minimal complete definition, beyond Shape:
///   - `matrix<double, dimension, dimension> hessian(const point<dimension>& x) const`: second derivative of
///     the distance [1/m], symmetric, with hessian(x) gradient(x) = 0.
template <class S>
concept CurvedShape = Shape<S> && requires(const S shape, const point<S::dimension> x) {
  { shape.hessian(x) } -> ExactMatrix<double, S::dimension, S::dimension>;
};

/// Hessian of the distance [1/m] of a shape at x; zero for a shape without hessian().
template <Shape S>
matrix<double, S::dimension, S::dimension> surface_curvature(const S& shape, const point<S::dimension>& x) {
  if constexpr (CurvedShape<S>) return shape.hessian(x);
  else return matrix<double, S::dimension, S::dimension>::Zero();
}

/// Smallest distance [m] between two opposite sides of a shape; of one without thickness() the smallest
/// extent of its bounds, without bounds infinite.
template <Shape S>
double thickness_of(const S& shape) {
  if constexpr (requires { shape.thickness(); }) {
    return shape.thickness();
  } else if constexpr (requires { shape.bounds(); }) {
    const auto bounds = shape.bounds();
    return (bounds.upper - bounds.lower).minCoeff();
  } else {
    return std::numeric_limits<double>::infinity();
  }
}

}  // namespace passive_haptics
