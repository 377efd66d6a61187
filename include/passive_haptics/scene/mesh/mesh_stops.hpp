/// The facets of a mesh as obstacles of a proxy.
#pragma once

#include <passive_haptics/scene/mesh/facet_slab.hpp>
#include <passive_haptics/scene/mesh/mesh.hpp>
#include <passive_haptics/scene/proxy/proxy_surface.hpp>

#include <algorithm>
#include <utility>

namespace passive_haptics {

/// Implements ProxySurface for a mesh by the slabs of its facets.
template <int D>
class mesh_stops {
 public:
  static constexpr int dimension = D;  ///< d

  double skin() const { return skin_; }                    ///< As ProxySurface [m].
  double crease_cosine() const { return crease_cosine_; }  ///< As ProxySurface.
  const mesh<D>& surface() const { return surface_; }      ///< The mesh.

  /// As ProxySurface: the first slab of the step, without resting facets. Searches the facets near the step.
  proxy_stop first_stop(const point<D>& p, const point<D>& step, std::span<const int> resting) const {
    const auto entry = [&](const four_outer_boxes<D>& boxes) {
      return typename four_outer_boxes<D>::four([&](int k) {
        detail::part_of_way way;
        for (int i = 0; i < D; ++i) {
          const auto axis = static_cast<std::size_t>(i);
          way.keep_between(p[i], step[i], double(boxes.lower[axis][k]) - 2 * skin_,
                           double(boxes.upper[axis][k]) + 2 * skin_);
        }
        return way.empty() ? 2.f : static_cast<float>(way.first);
      });
    };
    proxy_stop first;
    auto search = surface_.tree().start();
    surface_.tree().go_on(search, entry, first.time, [&](int place, double) {
      const int i = surface_.tree().item(place);
      const double time = slab(i).stop(p, step);
      const bool sooner = time < first.time || (time <= first.time && first.facet < 0);
      if (sooner && std::find(resting.begin(), resting.end(), i) == resting.end()) first = {time, i};
    });
    return first;
  }

  /// As ProxySurface.
  proxy_plane<D> plane(int facet, const point<D>&) const {
    return {surface_[facet].normal, surface_[facet].corners[0]};
  }
  bool holds(int facet, const point<D>& p) const { return slab(facet).holds(p); }  ///< As ProxySurface.
  /// As ProxySurface for a closed mesh, by a search for the nearest facet.
  point<D> entry(const point<D>& x) const {
    constexpr double flat = 1e-9;  // fraction of its box; a mesh that is folded flat encloses nothing
    const double box = (surface_.bounds().upper - surface_.bounds().lower).prod();
    if (!surface_.closed() || !(std::abs(surface_.content()) > flat * box)) return x;
    const auto nearest = surface_.nearest(x);
    if (surface_.signed_distance(x, nearest) >= 0) return x;
    return nearest.position + skin_ * surface_.normal_at(nearest);
  }

 protected:
  /// Stores the surface, the skin [m] and the cosine of the crease angle.
  mesh_stops(mesh<D> surface, double skin, double crease_cosine)
      : surface_(std::move(surface)), skin_(skin), crease_cosine_(crease_cosine) {}

  double slab_reach() const { return 4 * skin_; }  ///< Extent of a slab from its facet [m].

 private:
  detail::facet_slab<D> slab(int facet) const { return {surface_[facet], skin_, 1e-3 * skin_}; }

  mesh<D> surface_;
  double skin_;
  double crease_cosine_;
};

}  // namespace passive_haptics
