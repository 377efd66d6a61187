/// @file
/// A mesh as what stops a proxy.
#pragma once

#include <passive_haptics/scene/mesh/facet_slab.hpp>
#include <passive_haptics/scene/mesh/mesh.hpp>
#include <passive_haptics/scene/proxy/proxy_surface.hpp>

#include <algorithm>

namespace passive_haptics::detail {

/// The facets of a mesh by their slabs.
template <int D>
struct mesh_stops {
  const mesh<D>& surface;  ///< Of the facets.
  double skin;             ///< [m]

  static constexpr double lip_by_skin = 1e-3;  ///< Of a slab's lip.
  static constexpr double slab_reach = 4;      ///< No point of a facet's slab is further from it, in skins.

  /// The slab of a facet.
  facet_slab<D> slab(int facet) const { return {surface[facet], skin, lip_by_skin * skin}; }

  /// As of ProxySurface: the slab that the step enters first, but none of the facets on which the proxy
  /// rests.
  proxy_stop first_stop(const point<D>& p, const point<D>& step, std::span<const int> resting) const {
    const auto entry = [&](const four_outer_boxes<D>& boxes) {
      return typename four_outer_boxes<D>::four([&](int k) {
        part_of_way way;
        for (int i = 0; i < D; ++i) {
          const auto axis = static_cast<std::size_t>(i);
          way.keep_between(p[i], step[i], double(boxes.lower[axis][k]) - 2 * skin,
                           double(boxes.upper[axis][k]) + 2 * skin);
        }
        return way.empty() ? 2.f : static_cast<float>(way.first);
      });
    };
    proxy_stop first;
    auto search = surface.tree().start();
    surface.tree().go_on(search, entry, first.time, [&](int place, double) {
      const int i = surface.tree().item(place);
      const double time = slab(i).stop(p, step);
      const bool sooner = time < first.time || (time <= first.time && first.facet < 0);
      if (sooner && std::find(resting.begin(), resting.end(), i) == resting.end()) first = {time, i};
    });
    return first;
  }

  /// Where a handle that is first seen within the wall of a closed mesh is taken to have come through: a skin
  /// in front of the nearest point. x if it is not within.
  point<D> entry(const point<D>& x) const {
    constexpr double flat = 1e-9;  // of the box about it: all folded flat, such a mesh encloses nothing
    const double box = (surface.bounds().upper - surface.bounds().lower).prod();
    if (!surface.closed() || !(std::abs(surface.content()) > flat * box)) return x;
    const auto nearest = surface.nearest(x);
    if (surface.signed_distance(x, nearest) >= 0) return x;
    return nearest.position + skin * surface.normal_at(nearest);
  }
};

}  // namespace passive_haptics::detail
