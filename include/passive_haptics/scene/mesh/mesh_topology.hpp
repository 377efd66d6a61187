/// Topology of a mesh: shared edges and the normals there.
#pragma once

#include <passive_haptics/core/nth.hpp>
#include <passive_haptics/scene/mesh/mesh_parameters.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

namespace passive_haptics::detail {

/// Index of the first vertex in the same place, for each vertex.
template <int D>
std::vector<int> welded(const std::vector<point<D>>& vertices) {
  std::vector<int> order(vertices.size()), stands_for(vertices.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = static_cast<int>(k);
  const auto at = [&](int i) -> const point<D>& { return nth(vertices, i); };
  std::stable_sort(order.begin(), order.end(), [&](int i, int j) {
    return std::lexicographical_compare(at(i).begin(), at(i).end(), at(j).begin(), at(j).end());
  });
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool same = k > 0 && at(order[k]) == at(order[k - 1]);
    nth(stands_for, order[k]) = same ? nth(stands_for, order[k - 1]) : order[k];
  }
  return stands_for;
}

/// A facet at an edge between two vertices (3-D) or at a vertex (2-D, low = high).
template <int D>
struct ridge {
  int low, high;  // vertices
  int facet, index;
  int turn;  // 1 or -1, direction of the facet along the edge

  bool same_place(const ridge& other) const { return low == other.low && high == other.high; }
};

/// All ridges, sorted by place, then by facet.
template <int D>
std::vector<ridge<D>> sorted_ridges(const std::vector<std::array<int, static_cast<std::size_t>(D)>>& facets) {
  std::vector<ridge<D>> all;
  all.reserve(facets.size() * D);
  for (std::size_t k = 0; k < facets.size(); ++k) {
    for (int i = 0; i < D; ++i) {
      const int from = nth(facets[k], i);
      const int to = D == 2 ? from : nth(facets[k], (i + 1) % D);
      const int turn = D == 2 ? 1 - 2 * i : (from < to ? 1 : -1);
      all.push_back({std::min(from, to), std::max(from, to), static_cast<int>(k), i, turn});
    }
  }
  std::sort(all.begin(), all.end(), [](const ridge<D>& a, const ridge<D>& b) {
    return std::tie(a.low, a.high, a.facet) < std::tie(b.low, b.high, b.facet);
  });
  return all;
}

/// Returns why the facets that meet in [first, last) do not enclose anything; empty if they do.
template <int D>
std::string check_ridge(const ridge<D>* first, const ridge<D>* last) {
  int turns = 0;
  for (const ridge<D>* r = first; r != last; ++r) turns += r->turn;
  if (turns == 0) return {};  // also if two bodies touch in an edge
  std::string text = indexed(D == 2 ? "vertex " : "edge between vertices ", first->low, "");
  if (D == 3) text = indexed(text.append(" and "), first->high, "");
  text.append(" of a mesh_solid");
  if (last - first == 1)
    return indexed(text.append(" belongs to facet "), first->facet,
                   " only: expected a closed surface; close the hole, or use mesh_surface");
  if (last - first == 2)
    return indexed(indexed(text.append(": facets "), first->facet, " and "), first[1].facet,
                   " run the same way: expected opposite ways; swap two vertices of one of them");
  return indexed(text.append(" belongs to "), last - first,
                 " facets: expected as many that run one way as the other; remove what is within the solid");
}

/// Angles of a facet at its corners [rad]; 1 for segments.
template <int D>
std::array<double, static_cast<std::size_t>(D)> angles_of(const facet_corners<D>& c) {
  if constexpr (D == 2) return {1, 1};
  else {
    const point<D> a = c[1] - c[0], b = c[2] - c[1], back = c[0] - c[2];
    const double twice_area = cross<double>(a, b).norm();
    const double first = std::atan2(twice_area, -a.dot(back)), second = std::atan2(twice_area, -b.dot(a));
    return {first, second, std::numbers::pi - first - second};
  }
}

/// Enclosed area (2-D) times 2, or volume (3-D) times 6, about an origin; < 0 if inside out.
template <int D>
double enclosed(const std::vector<mesh_facet<D>>& facets) {
  double sum = 0;
  const point<D> origin = facets.front().corners[0];
  for (const mesh_facet<D>& f : facets) {
    const point<D> a = f.corners[0] - origin, b = f.corners[1] - origin;
    if constexpr (D == 2) sum += cross_in_plane(a, b);
    else sum += cross(a, b).dot(f.corners[2] - origin);
  }
  return sum;
}

}  // namespace passive_haptics::detail
