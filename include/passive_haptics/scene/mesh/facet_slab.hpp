/// The slab in front of a facet that stops a proxy.
#pragma once

#include <passive_haptics/scene/bounds/bounding_volume_tree.hpp>
#include <passive_haptics/scene/mesh/mesh_facet.hpp>

#include <algorithm>

namespace passive_haptics::detail {

/// The part [first, last] of the motion p + t step, t in [0, 1], that meets some conditions.
struct part_of_way {
  double first = 0, last = 1;

  /// Keeps the part where a + t b <= bound. NaN keeps nothing.
  void keep_below(double a, double b, double bound) {
    if (b > 0) last = std::min(last, (bound - a) / b);
    else if (b < 0) first = std::max(first, (bound - a) / b);
    else if (!(a <= bound)) last = -1;
  }
  /// Keeps the part where low <= a + t b <= high.
  void keep_between(double a, double b, double low, double high) {
    keep_below(a, b, high);
    keep_below(-a, -b, -low);
  }
  bool empty() const { return !(first <= last); }
};

/// Calls f(corner, outward) for each rim of a facet, with the outward unit vector in its plane.
template <int D, class F>
void for_each_rim(const mesh_facet<D>& f, const F& rim) {
  if constexpr (D == 2) {
    const point<D> along(-f.normal[1], f.normal[0]);
    rim(f.corners[0], point<D>(-along));
    rim(f.corners[1], along);
  } else {
    for (int i = 0; i < D; ++i) {
      const point<D> out = cross<double>(f.corner(i + 1) - f.corner(i), f.normal);
      rim(f.corner(i), point<D>(out / out.norm()));
    }
  }
}

/// All points at a height in [-lip, skin] over the facet, extended by a lip at its rims, which closes cracks
/// by rounding. The lip is much thinner than the skin, so a resting proxy is outside the slabs beyond a
/// convex edge.
template <int D>
struct facet_slab {
  const mesh_facet<D>& f;
  double skin;  // [m]
  double lip;   // [m]

  /// Time at which the motion p + step enters the slab; > 1 if it does not, or falls by less than a lip.
  double stop(const point<D>& p, const point<D>& step) const {
    constexpr double never = 2;
    const double fall = f.normal.dot(step), height = f.height(p);
    if (!(fall < 0) || !(height >= -lip) || !(height + fall < skin - lip)) return never;
    part_of_way way;
    way.keep_between(height, fall, -lip, skin);
    keep_beside(way, p, step);
    if (way.empty() || !(height + way.last * fall < skin - lip)) return never;
    return way.first;
  }

  /// True if p rests on the facet: in the slab, with a second lip for rounding.
  bool holds(const point<D>& p) const {
    const double height = f.height(p);
    if (!(height >= -2 * lip && height <= skin + lip)) return false;
    part_of_way way;
    facet_slab{f, skin, 2 * lip}.keep_beside(way, p, point<D>::Zero());
    return !way.empty();
  }

 private:
  void keep_beside(part_of_way& way, const point<D>& p, const point<D>& step) const {
    for_each_rim(f, [&](const point<D>& corner, const point<D>& out) {
      way.keep_below(out.dot(p - corner), out.dot(step), lip);
    });
    if constexpr (D == 3) {  // rims only would leave a long spike at the tip of a needle
      for (int i = 0; i < 3; ++i) {
        const auto [low, high] = std::minmax({f.corners[0][i], f.corners[1][i], f.corners[2][i]});
        way.keep_between(p[i], step[i], low - skin - lip, high + skin + lip);
      }
    }
  }
};

}  // namespace passive_haptics::detail
