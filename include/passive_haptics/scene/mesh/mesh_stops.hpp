/// @file
/// A mesh as what stops a proxy.
#pragma once

#include <passive_haptics/scene/mesh/facet_slab.hpp>
#include <passive_haptics/scene/mesh/mesh.hpp>
#include <passive_haptics/scene/proxy/proxy_surface.hpp>

#include <algorithm>
#include <utility>

namespace passive_haptics {

/// What a wall of a mesh is as a ProxySurface: its facets, by their slabs.
template <int D>
class mesh_stops {
 public:
  static constexpr int dimension = D;  ///< d

  double skin() const { return skin_; }                    ///< As of ProxySurface [m].
  double crease_cosine() const { return crease_cosine_; }  ///< As of ProxySurface.
  const mesh<D>& surface() const { return surface_; }      ///< The facets.

  /// As of ProxySurface: the slab that the step enters first, but none of the facets on which the proxy
  /// rests. Cost: a search of the few facets near the way.
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

  /// As of ProxySurface.
  proxy_plane<D> plane(int facet, const point<D>&) const {
    return {surface_[facet].normal, surface_[facet].corners[0]};
  }
  /// As of ProxySurface.
  bool holds(int facet, const point<D>& p) const { return slab(facet).holds(p); }
  /// As of ProxySurface: of a closed mesh. Cost: a search for the nearest facet.
  point<D> entry(const point<D>& x) const {
    constexpr double flat = 1e-9;  // of the box about it: all folded flat, such a mesh encloses nothing
    const double box = (surface_.bounds().upper - surface_.bounds().lower).prod();
    if (!surface_.closed() || !(std::abs(surface_.content()) > flat * box)) return x;
    const auto nearest = surface_.nearest(x);
    if (surface_.signed_distance(x, nearest) >= 0) return x;
    return nearest.position + skin_ * surface_.normal_at(nearest);
  }

 protected:
  /// A surface, the skin [m] and the cosine of the crease angle.
  mesh_stops(mesh<D> surface, double skin, double crease_cosine)
      : surface_(std::move(surface)), skin_(skin), crease_cosine_(crease_cosine) {}

  /// How far a slab reaches from its facet [m].
  double slab_reach() const { return 4 * skin_; }

 private:
  detail::facet_slab<D> slab(int facet) const { return {surface_[facet], skin_, 1e-3 * skin_}; }

  mesh<D> surface_;
  double skin_;
  double crease_cosine_;
};

}  // namespace passive_haptics
