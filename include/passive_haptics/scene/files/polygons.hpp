/// Polygons of a file, and the mesh of their triangles.
#pragma once

#include <passive_haptics/core/finite.hpp>
#include <passive_haptics/core/nth.hpp>
#include <passive_haptics/scene/files/ear_clipping.hpp>
#include <passive_haptics/scene/files/mesh_file.hpp>
#include <passive_haptics/scene/mesh/mesh_topology.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace passive_haptics::detail {

struct polygons {
  static constexpr std::size_t max_corners = 1000;                           ///< In one polygon.
  static constexpr std::size_t max_count = std::numeric_limits<int>::max();  ///< Vertices or triangles.

  std::vector<point<3>> vertices;
  std::vector<int> corners;             ///< Vertex indices of all polygons.
  std::vector<std::size_t> ends;        ///< End of each polygon in `corners`.
  std::vector<std::size_t> places;      ///< Place of each polygon in the file.
  const char* place_name = "polygon ";  ///< Unit of a place.

  std::size_t not_polygons = 0;  ///< Points and lines.
  std::size_t skipped_bytes = 0;
  std::size_t skipped_lines = 0;
  std::string first_skipped;  ///< "line 7: 'Kd'"

  /// Adds a polygon with valid vertex indices, at most `max_corners`.
  void add(std::span<const int> polygon, std::size_t place) {
    if (polygon.size() < 3) {
      ++not_polygons;
      return;
    }
    corners.insert(corners.end(), polygon.begin(), polygon.end());
    ends.push_back(corners.size());
    places.push_back(place);
  }
  /// Counts a line with an unknown keyword, "line 7: 'Kd'".
  void skip_line(const std::string& place) {
    if (skipped_lines++ == 0) first_skipped = place;
  }
};

/// Returns a mesh with only the used vertices, merged by place.
inline mesh_parameters<3> compact(const mesh_parameters<3>& m) {
  const std::vector<int> first = welded<3>(m.vertices);
  std::vector<int> number(m.vertices.size(), -1);
  mesh_parameters<3> used;
  used.facets = m.facets;
  for (auto& f : used.facets) {
    for (int& v : f) {
      const auto place = static_cast<std::size_t>(nth(first, v));
      if (number[place] < 0) {
        number[place] = static_cast<int>(used.vertices.size());
        used.vertices.push_back(m.vertices[place]);
      }
      v = number[place];
    }
  }
  return used;
}

/// Cuts all polygons into triangles. Returns an error text, empty if there is none.
inline std::string cut_all(const polygons& from, const std::vector<point<3>>& vertices,
                           std::vector<index_triangle>& triangles, std::vector<std::size_t>& twisted) {
  std::size_t begin = 0;
  for (std::size_t i = 0; i < from.ends.size(); begin = from.ends[i++]) {
    const auto polygon = std::span<const int>(from.corners).subspan(begin, from.ends[i] - begin);
    const auto here = [&](const std::string& error) {
      return indexed(from.place_name, from.places[i], ": ").append(error);
    };
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const point<3>& x = nth(vertices, polygon[k]);
      if (!all_finite(x))
        return here(indexed("corner ", k + 1, indexed(" = (", x[0], ", "))
                        .append(indexed("", x[1], ", "))
                        .append(indexed("", x[2], "): expected finite coordinates; the file is damaged")));
    }
    const polygon_cut cut = cut_polygon(vertices, polygon, triangles);
    if (cut == polygon_cut::twisted) twisted.push_back(from.places[i]);
    if (cut == polygon_cut::crossing)
      return here(indexed("a polygon of ", polygon.size(),
                          " corners crosses itself: expected its corners in their order around it; cut it "
                          "into triangles where the file is made"));
  }
  return triangles.size() > polygons::max_count ? "more than 2^31 - 1 triangles: expected fewer" : "";
}

inline std::string remarks_on(const mesh_file& file, const std::string& first_twisted,
                              const std::string& first_skipped) {
  std::string all;
  const auto remark = [&](const char* what, auto count, const std::string& more) {
    if (count > 0) all.append(indexed(what, count, more)).append("\n");
  };
  remark("triangles without area, left out: ", file.slivers, "; the mesh may be open there");
  remark("points and lines, left out: ", file.not_triangles, "");
  remark("twisted quads, cut along a diagonal: ", file.twisted_quads,
         ", the first at " + first_twisted + "; how they run between their edges is a guess");
  remark("lines with keywords of other programs, skipped: ", file.skipped_lines,
         ", the first is " + first_skipped);
  remark("bytes behind the end of the data, skipped: ", file.skipped_bytes, "");
  return all;
}

/// Makes one mesh of all polygons, with coordinates in metres. Returns an error text, empty if there is none.
inline std::string to_mesh(polygons&& from, double metres_per_unit, mesh_file& file) {
  const auto counted = [](std::size_t n) { return static_cast<int>(std::min(n, polygons::max_count)); };
  if (from.ends.empty()) {
    if (from.skipped_lines == 0) return "no triangles: expected one or more; points and lines have no sides";
    return from.first_skipped + ": expected a keyword of a mesh; the file has no triangles";
  }
  mesh_parameters<3> all{std::move(from.vertices), {}};
  for (point<3>& x : all.vertices) x *= metres_per_unit;
  std::vector<std::size_t> twisted;
  if (std::string error = cut_all(from, all.vertices, all.facets, twisted); !error.empty()) return error;
  for (point<3>& x : all.vertices)
    if (!all_finite(x)) x.setZero();  // unused vertices; NaN cannot be sorted
  const std::size_t count = all.facets.size();
  file.mesh = compact(without_slivers(std::move(all)));
  file.slivers = static_cast<int>(count - file.mesh.facets.size());
  file.not_triangles = counted(from.not_polygons);
  file.twisted_quads = counted(twisted.size());
  file.skipped_lines = counted(from.skipped_lines);
  file.skipped_bytes = from.skipped_bytes;
  file.remarks = remarks_on(file, twisted.empty() ? "" : indexed(from.place_name, twisted.front(), ""),
                            from.first_skipped);
  return file.mesh.facets.empty() ? "all triangles are degenerate (zero area): expected one with an area"
                                  : "";
}

}  // namespace passive_haptics::detail
