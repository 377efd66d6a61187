/// @file
/// The inside of a convex shape as one wall for each face.
#pragma once

#include <passive_haptics/scene/scene.hpp>
#include <passive_haptics/scene/shapes/complement.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>

#include <tuple>

namespace passive_haptics {

/// A shape bounded by planes: `faces()` gives an array of half-spaces whose common inside is the shape.
template <class S>
concept PlaneFaced = Shape<S> && requires(const S shape) {
  { shape.faces().front() } -> std::convertible_to<half_space<S::dimension>>;
  shape.faces().size();
};

/// A scene whose free space is the inside of a box, convex_polygon or convex_polytope.
///
/// complement(shape) would be one wall and so one contact, whose normal jumps where a corner is crossed. Here
/// each face is a wall of its own: in a corner all its faces are touched at once, each with its own depth,
/// and wall numbers are face numbers. Exact, since the points behind a face are those on the wrong
/// side of its plane. Stiffness in N/m, the same for all faces.
template <PlaneFaced S>
auto walls_of(const S& shape, double stiffness = 1e7) {
  const auto walls = [&](const auto&... face) { return scene(wall(complement(face), stiffness)...); };
  return std::apply(walls, shape.faces());
}

}  // namespace passive_haptics
