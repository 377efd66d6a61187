/// A closed mesh as a solid wall.
#pragma once

#include <passive_haptics/scene/mesh/mesh_stops.hpp>

#include <algorithm>
#include <numbers>
#include <utility>

namespace passive_haptics {

/// The surface of a solid.
template <int D>
struct mesh_solid_parameters {
  mesh<D> surface;  ///< Closed surface; its normals point out of the solid.
};

/// Returns an error text, empty if there is none. Intersecting facets are not detected.
template <int D>
std::string validate(const mesh_solid_parameters<D>& p) {
  if (!p.surface.closed()) return p.surface.hole();
  if (p.surface.content() > 0) return {};
  return detail::error_text(D == 2 ? "area of a mesh_solid [m^2]" : "volume of a mesh_solid [m^3]",
                            p.surface.content(),
                            "> 0; swap two vertices of every facet, or use complement() for a room");
}

/// Solid with distance(x) = +- |x - nearest point|; the sign is that of (x - nearest point) . pseudonormal.
/// In a scene it has at most one contact; use mesh_surface if several faces of a concave corner must be felt.
/// In a world its facets stop the handle's proxy, so it may be thin, and adjacent solids act as one.
template <int D>
class mesh_solid : public mesh_stops<D> {
 public:
  static constexpr bool has_unit_gradient = true;  ///< By construction.

  /// Throws std::invalid_argument with the text of validate(p).
  explicit mesh_solid(const mesh_solid_parameters<D>& p)
      : mesh_stops<D>(require_valid(p).surface,
                      std::max(1e-7, 1e-9 * detail::max_coordinate(p.surface.bounds())),
                      0.5 * std::numbers::sqrt3) {}  // 30 deg

  /// The solid inside a closed mesh.
  explicit mesh_solid(mesh<D> surface) : mesh_solid(mesh_solid_parameters<D>{std::move(surface)}) {}

  /// Signed distance [m], in about log n.
  double distance(const point<D>& x) const {
    return this->surface().signed_distance(x, this->surface().nearest(x));
  }

  /// Unit vector to the free side, on edges and corners the pseudonormal. Cost as distance().
  point<D> gradient(const point<D>& x) const {
    const auto nearest = this->surface().nearest(x);
    const point<D>& n = this->surface().normal_at(nearest);
    if (nearest.part == facet_part::interior) return n;
    const point<D> r = x - nearest.position;
    // The direction of a shorter r is rounding of the coordinates.
    constexpr double shortest = 1e6 * std::numeric_limits<double>::epsilon();
    if (r.norm() <= shortest * nearest.position.norm()) return n;
    return detail::direction_or<D>(r.dot(n) < 0 ? point<D>(-r) : r, n);
  }

  bounding_box<D> bounds() const { return this->surface().bounds(); }  ///< Bounding box.

  /// As ProxySurface, by a search for the nearest facet.
  double clearance(const point<D>& x, int& hint) const {
    const auto nearest = this->surface().nearest(x, hint);
    hint = nearest.facet;
    return this->surface().signed_distance(x, nearest) - this->slab_reach();
  }
  bool is_solid() const { return true; }  ///< As ProxySurface.
};

}  // namespace passive_haptics
