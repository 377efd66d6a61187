/// @file
/// The outline of a body in the plane, as of a mesh seen from above: a polygon that need not be convex.
#pragma once

#include <passive_haptics/scene/shape.hpp>

#include <vector>

namespace explorer {

namespace ph = passive_haptics;

/// A polygon of any number of corners, solid inside: a Shape. Its distance is exact on both sides; at a
/// corner the gradient leads away from the corner.
class outline {
 public:
  static constexpr int dimension = 2;              ///< d
  static constexpr bool has_unit_gradient = true;  ///< By construction.

  /// With these corners [m], either way round. Throws std::invalid_argument if sides cross or have no length.
  explicit outline(const std::vector<ph::point<2>>& corners);

  /// Signed distance [m]: < 0 inside.
  double distance(const ph::point<2>& x) const { return nearest(x).distance; }
  /// Unit vector out of the body.
  ph::point<2> gradient(const ph::point<2>& x) const { return nearest(x).gradient; }

 private:
  struct side {
    ph::point<2> start, along, normal;
    double length;
  };
  struct result {
    double distance;
    ph::point<2> gradient;
  };
  result nearest(const ph::point<2>& x) const;

  std::vector<side> sides_;  // counter-clockwise
};

}  // namespace explorer
