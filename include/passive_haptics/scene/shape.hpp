/// The Shape concept: a virtual wall as a signed distance.
#pragma once

#include <passive_haptics/core/matrix.hpp>

#include <concepts>
#include <limits>

namespace passive_haptics {

/// A point or direction of a scene [m]; always double, because depths are small differences.
template <int D>
using point = vector<double, D>;

namespace detail {
template <class S>
concept names_dimension = requires { requires(std::integral_constant<int, S::dimension>::value > 0); };
}  // namespace detail

/// The geometry of a wall.
///
/// Minimal complete definition:
///   - `static constexpr int dimension`;
///   - `double distance(const point<dimension>& x) const`: signed distance [m], positive in free space;
///   - `point<dimension> gradient(const point<dimension>& x) const`: its gradient, the outward unit normal.
///
/// Laws: |distance(x) - distance(y)| <= |x - y| (1-Lipschitz). gradient is the derivative of distance, or any
/// unit vector into free space if that does not exist. NaN in x gives a NaN distance.
/// testing/shape_properties.hpp checks these laws.
///
/// Optional, in addition to the members of MovingShape, CurvedShape and BoundedShape:
///   - `static constexpr bool has_unit_gradient = true`: the gradient has length 1 by construction, so a
///     scene need not check it;
///   - `void extrapolate(double seconds)`: extrapolates the motion by this time [s] (moving.hpp);
///   - `double thickness() const`: minimum distance between opposite sides [m], if below that of its bounds.
///
/// Shapes made from another shape keep them (shape_wrapper.hpp).
template <class S>
concept Shape = detail::names_dimension<S> && requires(const S shape, const point<S::dimension> x) {
  { shape.distance(x) } -> std::same_as<double>;
  { shape.gradient(x) } -> ExactVector<double, S::dimension>;
};

/// True if a shape declares has_unit_gradient.
template <class S>
inline constexpr bool gradient_is_unit = requires { requires S::has_unit_gradient; };

/// A shape that moves. Minimal complete definition, in addition to Shape:
///   - `point<dimension> velocity(const point<dimension>& x) const`: velocity of the surface nearest to x
///     [m/s].
template <class S>
concept MovingShape = Shape<S> && requires(const S shape, const point<S::dimension> x) {
  { shape.velocity(x) } -> ExactVector<double, S::dimension>;
};

/// Returns the velocity of the surface nearest to x [m/s]; zero without velocity().
template <Shape S>
point<S::dimension> surface_velocity(const S& shape, const point<S::dimension>& x) {
  if constexpr (MovingShape<S>) return shape.velocity(x);
  else return point<S::dimension>::Zero();
}

/// A shape that provides its curvature. Minimal complete definition, in addition to Shape:
///   - `matrix<double, dimension, dimension> hessian(const point<dimension>& x) const`: Hessian of the
///     distance [1/m], symmetric, with hessian(x) gradient(x) = 0.
template <class S>
concept CurvedShape = Shape<S> && requires(const S shape, const point<S::dimension> x) {
  { shape.hessian(x) } -> ExactMatrix<double, S::dimension, S::dimension>;
};

/// Returns the Hessian of the distance at x [1/m]; zero without hessian().
template <Shape S>
matrix<double, S::dimension, S::dimension> surface_curvature(const S& shape, const point<S::dimension>& x) {
  if constexpr (CurvedShape<S>) return shape.hessian(x);
  else return matrix<double, S::dimension, S::dimension>::Zero();
}

/// Returns the minimum distance between opposite sides of a shape [m]. Without thickness(): the minimum
/// extent of its bounds; without bounds: infinity.
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
