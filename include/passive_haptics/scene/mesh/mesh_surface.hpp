/// @file
/// A mesh as a wall with memory: thin, open or closed, with corners that are touched at several facets.
#pragma once

#include <passive_haptics/core/finite.hpp>
#include <passive_haptics/scene/mesh/mesh.hpp>
#include <passive_haptics/scene/mesh/proxy_contacts.hpp>
#include <passive_haptics/scene/world/tracked_shape.hpp>

#include <limits>
#include <numbers>
#include <utility>

namespace passive_haptics {

/// A surface and how it is felt.
template <int D>
struct mesh_surface_parameters {
  mesh<D> surface;     ///< Open or closed.
  double skin = 1e-7;  ///< From the surface to the proxy [m]: far over rounding, far under what is felt.
  /// Facets whose normals differ by less are one smooth surface [rad].
  double crease_angle = std::numbers::pi / 6;

  static constexpr const char* type_name = "a mesh_surface";  ///< In errors.
  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = mesh_surface_parameters;
    return member_table(member("skin", &p::skin, "m"),
                        member("crease_angle", &p::crease_angle, "rad",
                               range{0, std::numbers::pi, false, true}.as("0 or more and less than pi")));
  }
  /// The skin is far over the rounding of the surface's coordinates.
  std::string rules() const {
    constexpr double least_skin = 1e-9;  // a thousandth of it still is 4500 roundings
    const double size = detail::largest_coordinate(surface.bounds());
    if (skin >= least_skin * size && range::positive.contains(skin)) return {};
    return detail::error_text("skin of a mesh_surface [m]", skin,
                              detail::indexed("a finite number > 0 and at least ", least_skin * size,
                                              ", 1e-9 of the largest coordinate"));
  }
};

/// Stops what moves from the front of a facet to its back; from behind it is free. A proxy stays in front, so
/// that a handle pushed through a thin wall still is pushed back to where it came from. Where the proxy rests
/// in a concave corner, each face is a contact of its own.
///
/// Neighbours must share their vertices: a crack wider than a thousandth of the skin lets a handle through.
///
/// A handle that is seen for the first time within the wall of a closed mesh is taken to have come through
/// the nearest facet.
template <int D>
class mesh_surface {
 public:
  static constexpr int dimension = D;  ///< d
  using tracker = proxy_tracker<D>;    ///< What is remembered of one handle.

  /// Throws std::invalid_argument with the text of validate(p).
  explicit mesh_surface(const mesh_surface_parameters<D>& p)
      : surface_(require_valid(p).surface),
        skin_(p.skin),
        cos_crease_(std::cos(p.crease_angle)),
        far_(1e3 * (1 + detail::largest_coordinate(surface_.bounds()))) {}

  /// A surface that is felt as by default.
  explicit mesh_surface(mesh<D> surface) : mesh_surface(mesh_surface_parameters<D>{std::move(surface)}) {}

  /// The box about the surface and what a proxy stays away from it.
  bounding_box<D> bounds() const { return surface_.bounds().grown(slab_reach * skin_); }

  /// See TrackedShape. While it touches, `from` is not read. Cost: free, a search for the way and one for the
  /// nearest facet; in contact, a search or two of the few facets near the proxy.
  template <class Add>
  double follow(const point<D>& from, const point<D>& x, tracker& t, Add&& add) const {
    if (!all_finite(x)) {
      add(point<D>(point<D>::UnitX()), std::numeric_limits<double>::quiet_NaN());
      return 0;
    }
    if (!t.held) {
      const point<D> start = t.known && all_finite(from) ? limited(from) : entry(x, t);
      point<D>::Map(t.position.data()) = start;
    }
    t.known = true;
    detail::proxy_way<D>(surface_, skin_, t).go_to(limited(x));
    if (t.held) {
      detail::proxy_contacts<D>(surface_, t, x, cos_crease_).add_to(add);
      return 0;
    }
    const auto nearest = surface_.nearest(x, t.nearest);
    t.nearest = nearest.facet;
    return std::max(0.0, nearest.distance() - slab_reach * skin_);
  }

  /// Its facets.
  const mesh<D>& surface() const { return surface_; }

 private:
  static constexpr double slab_reach = 4;  // no point of a facet's slab is further from it, in skins

  // Coordinates so large that their rounding is thicker than a skin are brought nearer.
  point<D> limited(const point<D>& x) const { return x.cwiseMax(-far_).cwiseMin(far_); }

  // Where a handle that was not seen before is taken to come from.
  point<D> entry(const point<D>& x, const tracker& t) const {
    constexpr double flat = 1e-9;  // of the box about it: all folded flat, such a mesh encloses nothing
    const double box = (surface_.bounds().upper - surface_.bounds().lower).prod();
    if (!surface_.closed() || !(std::abs(surface_.content()) > flat * box)) return limited(x);
    const auto nearest = surface_.nearest(x, t.nearest);
    if (surface_.signed_distance(x, nearest) >= 0) return limited(x);
    return nearest.position + skin_ * surface_.normal_at(nearest);
  }

  mesh<D> surface_;
  double skin_;
  double cos_crease_;
  double far_;
};

}  // namespace passive_haptics
