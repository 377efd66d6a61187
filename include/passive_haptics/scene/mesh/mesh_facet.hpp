/// One facet of a mesh, a segment (2-D) or a triangle (3-D), and its nearest points.
#pragma once

#include <passive_haptics/core/nth.hpp>
#include <passive_haptics/scene/shape.hpp>
#include <passive_haptics/scene/shapes/directions.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <type_traits>

namespace passive_haptics {

/// The corners of a facet [m].
template <int D>
using facet_corners = std::array<point<D>, static_cast<std::size_t>(D)>;

/// D corners and the unit normal towards the free side: planar on the right of the direction from corner 0 to
/// 1 (counterclockwise polygons are solid), spatial where corners run counterclockwise.
template <int D>
struct mesh_facet {
  static_assert(D == 2 || D == 3, "passive_haptics: a facet is a segment (D = 2) or a triangle (D = 3).");

  facet_corners<D> corners;  ///< [m]
  point<D> normal;           ///< Unit vector.

  const point<D>& corner(int i) const { return nth(corners, i % D); }  ///< Corner i modulo D.
  /// Height n . (x - c) over the facet's plane [m].
  double height(const point<D>& x) const { return normal.dot(x - corners[0]); }
};

/// The part of a facet that contains a point.
enum class facet_part {
  corner,  ///< A corner.
  edge,    ///< Between corner i and the next (3-D).
  interior,
};

/// The point of a facet nearest to a query point.
template <int D>
struct facet_point {
  point<D> position;        ///< [m]
  double squared_distance;  ///< From the query point [m^2].
  facet_part part;          ///< Its part of the facet.
  int index;                ///< Index of the corner or edge.
};

namespace detail {

/// A triangle relative to its longest edge, scaled against over- and underflow.
template <int D>
struct on_longest_edge {
  point<D> along;     ///< Unit vector along the edge.
  double length;      ///< Scaled length of the edge, 1 to sqrt(D); 0 for a point.
  point<D> from, to;  ///< From the edge's second end to the third corner, and from there to its first end.

  explicit on_longest_edge(const facet_corners<D>& c) {
    const std::array<double, 3> square{(c[1] - c[0]).squaredNorm(), (c[2] - c[1]).squaredNorm(),
                                       (c[0] - c[2]).squaredNorm()};
    const auto longest = std::max_element(square.begin(), square.end()) - square.begin();
    const auto corner = [&](auto i) -> const point<D>& { return nth(c, (longest + i) % 3); };
    const point<D> edge = corner(1) - corner(0);
    const double size = edge.cwiseAbs().maxCoeff();
    along = edge / size;
    length = size > 0 ? along.norm() : size;
    along /= length;
    from = (corner(2) - corner(1)) / size;
    to = (corner(0) - corner(2)) / size;
  }
};

/// Smallest by largest extent: 1 for a segment, height by longest edge for a triangle. 0 without area.
template <int D>
double slenderness(const facet_corners<D>& c) {
  if constexpr (D == 2) {
    const double length = length_of(c[1] - c[0]);
    return length / length > 0 ? 1 : 0;
  } else {
    const on_longest_edge<D> edge(c);
    const double height = (edge.to - edge.along.dot(edge.to) * edge.along).norm();
    return edge.length == 0 ? 0 : height / edge.length;
  }
}

/// Unit normal; perpendicular to the long edge even for a needle, so all corners stay in the plane.
template <int D>
point<D> normal_of(const facet_corners<D>& c) {
  if constexpr (D == 2) {
    const point<D> along = direction_of(c[1] - c[0]);
    return {along[1], -along[0]};
  } else {
    const on_longest_edge<D> edge(c);
    point<D> n = cross<double>(edge.from, edge.to);
    for (int pass = 0; pass < 2; ++pass) n -= edge.along.dot(n) * edge.along;
    return n.normalized();
  }
}

template <int D>
facet_point<D> nearest_on_segment(const point<D>& a, const point<D>& b, const point<D>& x, int edge) {
  const point<D> along = b - a;
  const double s = along.dot(x - a), whole = along.squaredNorm();
  if (!(s > 0)) return {a, (x - a).squaredNorm(), facet_part::corner, edge};
  if (!(s < whole)) return {b, (x - b).squaredNorm(), facet_part::corner, (edge + 1) % D};
  const point<D> foot = a + s / whole * along;
  return {foot, (x - foot).squaredNorm(), facet_part::edge, edge};
}

}  // namespace detail

/// Returns the point of a facet nearest to x. NaN in x gives a NaN distance. The distance may be infinite if
/// the facet is further away than the square root of `limit` [m^2].
///
/// The foot of x on the plane if it is inside all edges, else a point of an edge with the foot on its outer
/// side. Barycentric coordinates (Ericson, Real-Time Collision Detection, 2005, ch. 5.1.5) are inaccurate for
/// needles.
template <int D>
facet_point<D> nearest_point(const mesh_facet<D>& f, const std::type_identity_t<point<D>>& x,
                             double limit = std::numeric_limits<double>::infinity()) {
  const double h = f.height(x);
  facet_point<D> best{x, std::numeric_limits<double>::infinity(), facet_part::interior, 0};
  if (h * h > limit) return best;
  const auto on_plane = [&] { return facet_point<D>{x - h * f.normal, h * h, facet_part::interior, 0}; };
  if constexpr (D == 2) {
    const auto on_segment = detail::nearest_on_segment<D>(f.corners[0], f.corners[1], x, 0);
    return on_segment.part == facet_part::corner ? on_segment : on_plane();
  } else {
    bool inside = true;
    for (int i = 0; i < 3; ++i) {
      const point<D>&a = f.corner(i), &b = f.corner(i + 1);
      const point<D> along = b - a;
      const double behind = f.normal.dot(cross<double>(x - a, along));  // times the length of the edge
      if (!(behind > 0)) continue;
      inside = false;
      if (behind * behind > (limit - h * h) * along.squaredNorm()) break;
      const auto on_edge = detail::nearest_on_segment<D>(a, b, x, i);
      if (on_edge.squared_distance < best.squared_distance) best = on_edge;
    }
    return inside ? on_plane() : best;
  }
}

}  // namespace passive_haptics
