/// @file
/// Polygons as files have them, and the triangles that they are cut into.
#pragma once

#include <passive_haptics/core/finite.hpp>
#include <passive_haptics/scene/mesh/mesh_topology.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace passive_haptics {

/// What was found in a file of meshes.
struct mesh_file {
  mesh_parameters<3> mesh;  ///< All of its triangles as one mesh, vertices in the same place as one.
  /// Triangles without area that were left out; a mesh may be open there, see without_slivers.
  int slivers = 0;
  int not_triangles = 0;  ///< Points and lines that were left out.
};

namespace detail {

/// Vertices, and polygons one after the other.
struct polygons {
  static constexpr std::size_t max_corners = 1000;                           ///< Of one polygon.
  static constexpr std::size_t max_count = std::numeric_limits<int>::max();  ///< Vertices or triangles.

  std::vector<point<3>> vertices;
  std::vector<int> corners;       ///< Of all polygons; each is the index of a vertex, which is to be valid.
  std::vector<std::size_t> ends;  ///< Where in `corners` each polygon ends.
  std::size_t not_polygons = 0;   ///< Points and lines, which were left out.

  /// Adds one; its corners must be indices of vertices, at most `max_corners`.
  void add(std::span<const int> polygon) {
    if (polygon.size() < 3) {
      ++not_polygons;
      return;
    }
    corners.insert(corners.end(), polygon.begin(), polygon.end());
    ends.push_back(corners.size());
  }
};

/// Cuts a polygon into triangles that all fan out from one corner, the first for which none is turned over:
/// corner 0 of a convex polygon. False if there is no such corner.
inline bool add_fan(const std::vector<point<3>>& vertices, std::span<const int> polygon,
                    std::vector<std::array<int, 3>>& triangles) {
  const std::size_t n = polygon.size();
  const auto corner = [&](std::size_t i) { return polygon[i % n]; };
  const auto at = [&](std::size_t i) -> const point<3>& {
    return vertices[static_cast<std::size_t>(corner(i))];
  };
  const auto turn = [&](std::size_t from, std::size_t k) {
    const point<3> u = at(from + k) - at(from), v = at(from + k + 1) - at(from);
    return cross(u, v);
  };
  point<3> whole = point<3>::Zero();  // twice the area, along the normal
  for (std::size_t k = 1; k + 1 < n; ++k) whole += turn(0, k);
  const double rounding = 1e-9 * whole.squaredNorm();
  for (std::size_t from = 0; from < n; ++from) {
    std::size_t k = 1;
    while (k + 1 < n && (n == 3 || turn(from, k).dot(whole) >= -rounding)) ++k;
    if (k + 1 < n) continue;
    for (k = 1; k + 1 < n; ++k) triangles.push_back({corner(from), corner(from + k), corner(from + k + 1)});
    return true;
  }
  return false;
}

/// A copy of a mesh with only the vertices that are used, each place once.
inline mesh_parameters<3> compact(const mesh_parameters<3>& m) {
  const std::vector<int> first = welded<3>(m.vertices);
  std::vector<int> number(m.vertices.size(), -1);
  mesh_parameters<3> used;
  used.facets = m.facets;
  for (auto& f : used.facets) {
    for (int& v : f) {
      const auto place = static_cast<std::size_t>(first[static_cast<std::size_t>(v)]);
      if (number[place] < 0) {
        number[place] = static_cast<int>(used.vertices.size());
        used.vertices.push_back(m.vertices[place]);
      }
      v = number[place];
    }
  }
  return used;
}

/// Makes one mesh of all polygons, with coordinates in metres; empty, or why there is none.
inline std::string to_mesh(polygons&& from, double metres_per_unit, mesh_file& file) {
  for (std::size_t v = 0; v < from.vertices.size(); ++v) {
    from.vertices[v] *= metres_per_unit;
    if (!all_finite(from.vertices[v]))
      return indexed("vertex ", v, " is not finite, expected coordinates; the file is damaged");
  }
  file.not_triangles = static_cast<int>(std::min(from.not_polygons, polygons::max_count));
  if (from.ends.empty()) return "no triangles, expected one or more; points and lines have no sides";
  mesh_parameters<3> all{std::move(from.vertices), {}};
  std::size_t begin = 0;
  for (std::size_t i = 0; i < from.ends.size(); begin = from.ends[i++]) {
    const auto polygon = std::span<const int>(from.corners).subspan(begin, from.ends[i] - begin);
    if (!add_fan(all.vertices, polygon, all.facets))
      return indexed("polygon ", i, " is concave, expected triangles; cut it where the file is made");
  }
  const std::size_t count = all.facets.size();
  if (count > polygons::max_count) return "more than 2^31 - 1 triangles, expected fewer";
  file.mesh = compact(without_slivers(std::move(all)));
  file.slivers = static_cast<int>(count - file.mesh.facets.size());
  return file.mesh.facets.empty() ? "no triangle has an area, expected one or more" : "";
}

}  // namespace detail
}  // namespace passive_haptics
