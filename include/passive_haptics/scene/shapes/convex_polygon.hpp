/// Convex polygons by their corners.
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/scene/bounds/bounding_box.hpp>
#include <passive_haptics/scene/shapes/directions.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>

#include <array>
#include <concepts>
#include <limits>
#include <string>
#include <tuple>

namespace passive_haptics {

namespace detail {
/// Twice the area enclosed by the corners [m^2], > 0 if counterclockwise.
template <std::size_t K>
double twice_area(const std::array<point<2>, K>& corners) {
  double area = 0;
  for (std::size_t i = 1; i + 1 < K; ++i)
    area += cross_in_plane(point<2>(corners[i] - corners[0]), point<2>(corners[i + 1] - corners[0]));
  return area;
}
}  // namespace detail

/// Parameters of convex_polygon: the corners in either order around it.
template <int K>
struct convex_polygon_parameters {
  /// [m]; three on a line are allowed.
  std::array<point<2>, static_cast<std::size_t>(K)> corners = nowhere();

  static constexpr const char* type_name = "a convex_polygon";  ///< In errors.
  /// Default corners, all in one place, which is an error.
  static std::array<point<2>, static_cast<std::size_t>(K)> nowhere() {
    std::array<point<2>, static_cast<std::size_t>(K)> all;
    all.fill({0, 0});
    return all;
  }
  static constexpr auto members() {
    using p = convex_polygon_parameters;
    return member_table(member("corners", &p::corners, "m", range::finite));
  }
  /// Requires a convex polygon with an area, in O(K^2).
  std::string rules() const {
    const auto corner = [&](std::size_t i) { return corners[i % corners.size()]; };
    const auto name = [](std::size_t i) { return detail::indexed("corner ", i, " of a convex_polygon "); };
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (corner(i) == corner(i + 1)) return name(i) + "equals the next one: expected distinct corners";
    }
    const double area = detail::twice_area(corners);
    if (!std::isfinite(area) || area == 0)
      return detail::error_text("area of a convex_polygon [m^2]", area, "> 0");
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const point<2> edge = corner(i + 1) - corner(i);
      for (std::size_t j = 0; j < corners.size(); ++j) {
        const point<2> r = corner(j) - corner(i);
        if (sgn(area) * cross_in_plane(edge, r) < -rounding_tolerance<double>(2) * edge.norm() * r.norm())
          return name(j) + "lies outside the edge after corner " + std::to_string(i) +
                 ": expected a convex polygon";
      }
    }
    return {};
  }
};

/// distance(x) = max_i n_i . (x - c_i) inside, the distance to the nearest edge outside; exact on both sides.
/// Among equally near edges inside, the first determines the gradient.
template <int K>
class convex_polygon {
  static_assert(K >= 3, "passive_haptics: a convex_polygon has three corners or more.");
  static constexpr auto corner_count = static_cast<std::size_t>(K);

 public:
  static constexpr int dimension = 2;              ///< d
  static constexpr bool has_unit_gradient = true;  ///< By construction.

  /// Throws std::invalid_argument with the text of validate(p).
  template <std::same_as<convex_polygon_parameters<K>> Parameters>  // a template, so that {...} means corners
  explicit convex_polygon(const Parameters& p) {
    const double turn = sgn(detail::twice_area(require_valid(p).corners));
    std::size_t next = 0;
    for (edge& e : edges_) {
      const point<2>& start = p.corners[next];
      next = (next + 1) % corner_count;
      const auto r = (p.corners[next] - start).eval();
      const auto along = direction_of(r);
      e = {start, along, {turn * along.y(), -turn * along.x()}, length_of(r)};
    }
  }

  /// Polygon with these corners [m]: convex_polygon({{0, 0}, {1, 0}, {0, 1}}).
  explicit convex_polygon(const point<2> (&corners)[corner_count])
      : convex_polygon(convex_polygon_parameters<K>{std::to_array(corners)}) {}

  double distance(const point<2>& x) const { return nearest(x).distance; }  ///< Signed distance [m], in O(K).

  /// Unit vector to the free side.
  point<2> gradient(const point<2>& x) const { return nearest(x).gradient; }

  /// (I - n n^T) / distance(x) [1/m] if a corner is nearest from outside, else zero.
  matrix<double, 2, 2> hessian(const point<2>& x) const {
    const result at = nearest(x);
    if (!at.is_corner) return matrix<double, 2, 2>::Zero();
    return detail::hessian_of_length<2>(at.distance * at.gradient, matrix<double, 2, 2>::Identity());
  }

  /// The edges as walls with the polygon as their common inside, in the order of their start corners.
  std::array<half_space<2>, corner_count> faces() const {
    const auto walls = [](const auto&... e) { return std::array{half_space<2>(e.start, e.normal)...}; };
    return std::apply(walls, edges_);
  }

  /// Bounding rectangle.
  bounding_box<2> bounds() const {
    bounding_box<2> box;
    for (const edge& e : edges_) box.extend(e.start);
    return box;
  }

 private:
  struct edge {
    point<2> start, along, normal;
    double length;
  };
  struct result {
    double distance;
    point<2> gradient;
    bool is_corner;
  };

  template <class Point>  // instantiated only if used
  result nearest(const Point& x) const {
    result inside{-std::numeric_limits<double>::infinity(), Point::Zero(), false};
    result outside{std::numeric_limits<double>::infinity(), {1, 0}, false};
    for (const edge& e : edges_) {
      const Point r = x - e.start;
      const double over = e.normal.dot(r), s = e.along.dot(r);
      if (!(over <= inside.distance)) inside = {over, e.normal, false};
      if (!(over > 0)) continue;  // from outside, the nearest edge is in sight
      if (s >= 0 && s <= e.length) return {over, e.normal, false};  // all of the polygon is behind this edge
      const Point from_corner = s < 0 ? r : Point(r - e.length * e.along);
      const double d = from_corner.norm();
      if (d < outside.distance) outside = {d, detail::direction_or<2>(from_corner, e.normal), true};
    }
    return inside.distance > 0 ? outside : inside;
  }

  std::array<edge, corner_count> edges_;
};

/// Deduces the number of corners from the list.
template <std::size_t K>
convex_polygon(const point<2> (&)[K]) -> convex_polygon<static_cast<int>(K)>;

/// Deduces the number of corners from the parameters.
template <int K>
convex_polygon(const convex_polygon_parameters<K>&) -> convex_polygon<K>;

}  // namespace passive_haptics
