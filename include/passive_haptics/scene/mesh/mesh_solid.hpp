/// @file
/// A closed mesh as a solid wall.
#pragma once

#include <passive_haptics/scene/mesh/mesh_stops.hpp>

#include <algorithm>
#include <numbers>
#include <span>
#include <utility>

namespace passive_haptics {

/// The surface of a solid.
template <int D>
struct mesh_solid_parameters {
  mesh<D> surface;  ///< Closed; its normals point out of the solid.
};

/// What is wrong with the parameters; empty if nothing. Whether facets cross each other is not looked at.
template <int D>
std::string validate(const mesh_solid_parameters<D>& p) {
  if (!p.surface.closed()) return p.surface.hole();
  if (p.surface.content() > 0) return {};
  return detail::error_text(D == 2 ? "area of a mesh_solid [m^2]" : "volume of a mesh_solid [m^3]",
                            p.surface.content(),
                            "> 0; swap two vertices of every facet, or take complement() for a room");
}

/// distance(x) = +- |x - nearest point|, with the sign of (x - nearest point) . pseudonormal there. Exact on
/// both sides.
///
/// In a scene it gives one contact at most, as every shape, and none for what has been passed through: for
/// thin walls and corners that are touched from inside take mesh_surface. In a world its facets stop the
/// handle's proxy, so that solids side by side are one.
template <int D>
class mesh_solid {
 public:
  static constexpr int dimension = D;              ///< d
  static constexpr bool has_unit_gradient = true;  ///< By construction.

  /// Throws std::invalid_argument with the text of validate(p).
  explicit mesh_solid(const mesh_solid_parameters<D>& p)
      : surface_(require_valid(p).surface),
        skin_(std::max(1e-7, 1e-9 * detail::largest_coordinate(surface_.bounds()))) {}

  /// The solid within a closed mesh.
  explicit mesh_solid(mesh<D> surface) : mesh_solid(mesh_solid_parameters<D>{std::move(surface)}) {}

  /// Signed distance [m]; a search of about log n facets.
  double distance(const point<D>& x) const { return surface_.signed_distance(x, surface_.nearest(x)); }

  /// Unit vector away from the nearest point of the surface, to the free side; on an edge or corner, where
  /// there are many, the pseudonormal. Cost as distance.
  point<D> gradient(const point<D>& x) const {
    const auto nearest = surface_.nearest(x);
    const point<D>& n = surface_.normal_at(nearest);
    if (nearest.part == facet_part::interior) return n;
    const point<D> r = x - nearest.position;
    // A shorter r has no direction: its rounding is that of the coordinates.
    constexpr double shortest = 1e6 * std::numeric_limits<double>::epsilon();
    if (r.norm() <= shortest * nearest.position.norm()) return n;
    return detail::direction_or<D>(r.dot(n) < 0 ? point<D>(-r) : r, n);
  }

  /// The box about the solid.
  bounding_box<D> bounds() const { return surface_.bounds(); }

  double skin() const { return skin_; }  ///< As of ProxySurface [m].
  /// As of ProxySurface: of 30 deg.
  double crease_cosine() const { return 0.5 * std::numbers::sqrt3; }
  /// As of ProxySurface. Cost: a search of the few facets near the way.
  proxy_stop first_stop(const point<D>& p, const point<D>& step, std::span<const int> resting) const {
    return slabs().first_stop(p, step, resting);
  }
  /// As of ProxySurface.
  proxy_plane<D> plane(int facet, const point<D>& p) const {
    return {surface_[facet].normal, surface_[facet].height(p)};
  }
  /// As of ProxySurface.
  bool holds(int facet, const point<D>& p) const { return slabs().slab(facet).holds(p); }
  /// As of ProxySurface. Cost: a search for the nearest facet.
  double clearance(const point<D>& x, int& hint) const {
    const auto nearest = surface_.nearest(x, hint);
    hint = nearest.facet;
    return surface_.signed_distance(x, nearest) - detail::mesh_stops<D>::slab_reach * skin_;
  }
  /// As of ProxySurface.
  bool is_solid() const { return true; }
  /// As of ProxySurface. Cost: a search for the nearest facet.
  point<D> entry(const point<D>& x) const { return slabs().entry(x); }

  /// Its surface.
  const mesh<D>& surface() const { return surface_; }

 private:
  detail::mesh_stops<D> slabs() const { return {surface_, skin_}; }

  mesh<D> surface_;
  double skin_;  // [m]
};

}  // namespace passive_haptics
