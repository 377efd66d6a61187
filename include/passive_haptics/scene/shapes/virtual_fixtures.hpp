/// Guidance along a line or in a plane by walls.
///
/// Reference: L. B. Rosenberg, Virtual fixtures: perceptual tools for telerobotic manipulation, IEEE VRAIS
/// 1993, pp. 76-82. force/effects/guide.hpp is the counterpart by resistance without a wall.
#pragma once

#include <passive_haptics/scene/scene.hpp>
#include <passive_haptics/scene/shapes/capsule.hpp>
#include <passive_haptics/scene/shapes/complement.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>

namespace passive_haptics {

/// Returns the free space within radius [m] of the segment between two points [m], with round ends.
template <int D>
complement<capsule<D>> tube(const point<D>& from, const point<D>& to, double radius) {
  return complement<capsule<D>>(capsule<D>(from, to, radius));
}

/// Free space within half_width [m] of the plane (2-D: line) through a point [m]. At most one of its walls is
/// touched at a time; wall 0 is on the side of the normal. Stiffness in N/m.
template <int D>
static_scene<half_space<D>, half_space<D>> slot(const point<D>& centre, const point<D>& normal,
                                                double half_width, double stiffness = 1e7) {
  require_no_error(check_value("half_width", half_width, "m", range::not_negative, "a slot"));
  const point<D> n = direction_of(normal);
  return scene(wall(half_space<D>(centre + half_width * n, -n), stiffness),
               wall(half_space<D>(centre - half_width * n, n), stiffness));
}

}  // namespace passive_haptics
