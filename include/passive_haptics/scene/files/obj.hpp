/// @file
/// Meshes from Wavefront OBJ files.
#pragma once

#include <passive_haptics/scene/files/mesh_source.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

namespace passive_haptics {
namespace detail {

/// What says nothing of where a surface is.
inline bool is_no_geometry_of_obj(std::string_view word) {
  constexpr std::array<std::string_view, 17> words{
      "vt",     "vn",  "o",  "g",     "s",        "mg",       "usemtl",     "mtllib",   "usemap",
      "maplib", "lod", "vp", "bevel", "c_interp", "d_interp", "shadow_obj", "trace_obj"};
  return word.front() == '#' || std::find(words.begin(), words.end(), word) != words.end();
}

/// "7", "7/2", "7//3" or "-1/2/3": the index of a vertex, from 1 or back from the last one; those of texture
/// and normal are not read.
inline int obj_index(const mesh_source& from, std::string_view word, std::size_t vertex_count) {
  const auto count = static_cast<std::int64_t>(vertex_count);
  if (word.front() == '/') from.fail(word, "the number of a vertex");
  const auto named = from.number<std::int64_t>(word.substr(0, word.find('/')), "the number of a vertex");
  if (named == 0 || named > count || named < -count)
    from.fail(word, indexed("a vertex of the ", count, " above, from 1, or back from -1"));
  return static_cast<int>(named > 0 ? named - 1 : count + named);
}

inline void read_obj(const std::filesystem::path& path, polygons& to) {
  mesh_source from(path);
  std::vector<int> corners;
  for (std::string_view word = from.word(); !word.empty(); from.next_line(), word = from.word()) {
    if (word == "v") {
      point<3> x;
      for (double& coordinate : x) coordinate = from.number<double>(from.word_in_line(), "a coordinate");
      if (to.vertices.size() == polygons::max_count) from.fail(word, "fewer vertices");
      while (!(word = from.word_in_line()).empty() && word.front() != '#')
        from.number<double>(word, "a weight or a colour");
      to.vertices.push_back(x);
    } else if (word == "f") {
      corners.clear();
      while (!(word = from.word_in_line()).empty() && word.front() != '#') {
        if (corners.size() == polygons::max_corners) from.fail(word, "a polygon of fewer corners");
        corners.push_back(obj_index(from, word, to.vertices.size()));
      }
      if (corners.size() < 3) from.fail(word, "three corners or more");
      to.add(corners);
    } else if (word == "l" || word == "p") {
      ++to.not_polygons;
    } else if (!is_no_geometry_of_obj(word)) {
      from.fail(word, "v, f or another keyword of a mesh; curves and free-form surfaces are not read");
    }
  }
}

}  // namespace detail

/// The mesh of an OBJ file whose unit is `metres_per_unit` (1e-3: millimetres): all objects and groups as
/// one. Polygons are cut into triangles; one that no fan of triangles fills is refused. A face names vertices
/// of lines above it.
///
/// Throws std::invalid_argument that names file and line, and what was expected: no regular file, not OBJ, an
/// index out of range, coordinates that are not finite, no triangle with an area, a scale that is not
/// positive. For set-up, never for a control cycle.
inline mesh_file read_obj(const std::filesystem::path& path, double metres_per_unit = 1) {
  return detail::read_mesh_file(path, metres_per_unit, detail::read_obj);
}

}  // namespace passive_haptics
