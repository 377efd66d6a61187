/// The inside of a convex shape with one wall per face.
#pragma once

#include <passive_haptics/scene/scene.hpp>
#include <passive_haptics/scene/shapes/complement.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>

#include <tuple>

namespace passive_haptics {

/// A shape bounded by planes: `faces()` returns an array of half-spaces, the shape is their common inside.
template <class S>
concept PlaneFaced = Shape<S> && requires(const S shape) {
  { shape.faces().front() } -> std::convertible_to<half_space<S::dimension>>;
  shape.faces().size();
};

/// Returns a scene with the inside of a box, convex_polygon or convex_polytope as its free space.
///
/// complement(shape) would be one wall with one contact, and its normal would jump at a corner. Here each
/// face is a wall with its own contact and number. Stiffness in N/m, for all faces.
template <PlaneFaced S>
auto walls_of(const S& shape, double stiffness = 1e7) {
  const auto walls = [&](const auto&... face) { return scene(wall(complement(face), stiffness)...); };
  return std::apply(walls, shape.faces());
}

}  // namespace passive_haptics
