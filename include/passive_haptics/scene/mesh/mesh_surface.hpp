/// A mesh as a wall with memory: thin, open or closed, with concave corners that touch several facets.
#pragma once

#include <passive_haptics/core/finite.hpp>
#include <passive_haptics/scene/mesh/mesh.hpp>
#include <passive_haptics/scene/mesh/mesh_stops.hpp>
#include <passive_haptics/scene/proxy/proxy_contacts.hpp>
#include <passive_haptics/scene/world/tracked_shape.hpp>

#include <limits>
#include <numbers>
#include <utility>

namespace passive_haptics {

/// Parameters of mesh_surface.
template <int D>
struct mesh_surface_parameters {
  mesh<D> surface;     ///< Open or closed.
  double skin = 1e-7;  ///< Distance of a proxy [m], far above rounding and below perception.
  /// Facets with a smaller angle between their normals form one smooth surface [rad].
  double crease_angle = std::numbers::pi / 6;

  static constexpr const char* type_name = "a mesh_surface";  ///< In errors.
  static constexpr auto members() {
    using p = mesh_surface_parameters;
    return member_table(member("skin", &p::skin, "m"),
                        member("crease_angle", &p::crease_angle, "rad",
                               range{0, std::numbers::pi, false, true}.as("0 or more and less than pi")));
  }
  /// Requires a skin far above the rounding of the coordinates.
  std::string rules() const {
    constexpr double min_skin = 1e-9;  // a thousandth of it is 4500 roundings
    const double size = detail::max_coordinate(surface.bounds());
    if (skin >= min_skin * size && range::positive.contains(skin)) return {};
    return detail::error_text("skin of a mesh_surface [m]", skin,
                              detail::indexed("a finite number > 0 and at least ", min_skin * size,
                                              ", 1e-9 of the largest coordinate"));
  }
};

/// A wall that stops motion from the front of a facet to its back. The proxy stays in front, so that a handle
/// pushed through a thin wall is pushed back to its original side. In a concave corner each face is a
/// contact. Neighbouring facets must share vertices: a crack wider than a thousandth of the skin lets a
/// handle through. A handle first seen inside a closed mesh is assumed to have entered through the nearest
/// facet.
template <int D>
class mesh_surface : public mesh_stops<D> {
 public:
  using tracker = proxy_tracker<D>;  ///< State of one handle.

  /// Throws std::invalid_argument with the text of validate(p).
  explicit mesh_surface(const mesh_surface_parameters<D>& p)
      : mesh_stops<D>(require_valid(p).surface, p.skin, std::cos(p.crease_angle)),
        far_(1e3 * (1 + detail::max_coordinate(p.surface.bounds()))) {}

  /// A surface with default parameters.
  explicit mesh_surface(mesh<D> surface) : mesh_surface(mesh_surface_parameters<D>{std::move(surface)}) {}

  /// Bounding box of the surface and its slabs.
  bounding_box<D> bounds() const { return this->surface().bounds().grown(this->slab_reach()); }

  /// As TrackedShape. `from` is ignored during contact. Cost: one search for the motion and one for the
  /// nearest facet in free space; one or two local searches in contact.
  template <class Add>
  double follow(const point<D>& from, const point<D>& x, tracker& t, Add&& add) const {
    if (!all_finite(x)) {
      add(point<D>(point<D>::UnitX()), std::numeric_limits<double>::quiet_NaN());
      return 0;
    }
    if (!t.held)
      point<D>::Map(t.position.data()) =
          t.known && all_finite(from) ? within_reach(from) : within_reach(this->entry(x));
    t.known = true;
    const placed_surface<mesh_surface> here{this, point<D>::Zero(), 0};
    const std::span<const placed_surface<mesh_surface>> all(&here, 1);
    detail::proxy_path<mesh_surface>(all, t).go_to(within_reach(x));
    if (!t.held) return std::max(0.0, clearance(x, t.nearest));
    detail::proxy_contacts<mesh_surface>(all, t, x).add_to(
        [&add](const point<D>& normal, double depth, int) { add(normal, depth); });
    return 0;
  }

  /// As ProxySurface, by a search for the nearest facet.
  double clearance(const point<D>& x, int& hint) const {
    const auto nearest = this->surface().nearest(x, hint);
    hint = nearest.facet;
    return nearest.distance() - this->slab_reach();
  }
  bool is_solid() const { return false; }  ///< As ProxySurface.

 private:
  // Limits coordinates with rounding thicker than a skin.
  point<D> within_reach(const point<D>& x) const { return x.cwiseMax(-far_).cwiseMin(far_); }

  double far_;
};

}  // namespace passive_haptics
