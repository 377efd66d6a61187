/// Meshes from Wavefront OBJ files.
#pragma once

#include <passive_haptics/scene/files/mesh_source.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace passive_haptics {
namespace detail {

inline constexpr std::array<std::string_view, 18> no_geometry_of_obj{
    "vt",     "vn",  "o",  "g",     "s",        "mg",       "usemtl",     "mtllib",    "usemap",
    "maplib", "lod", "vp", "bevel", "c_interp", "d_interp", "shadow_obj", "trace_obj", "t"};
/// Keywords of curves, free-form surfaces and other files.
inline constexpr std::array<std::string_view, 8> not_read_of_obj{"curv", "curv2", "surf", "bzp",
                                                                 "bsp",  "cdc",   "cdp",  "call"};

inline bool is_one_of(std::string_view word, std::span<const std::string_view> keywords) {
  return std::any_of(keywords.begin(), keywords.end(),
                     [&](std::string_view k) { return is_keyword(word, k); });
}

/// True for a possible keyword of another program: a letter, then letters, digits or '_'.
inline bool is_unknown_keyword(std::string_view word) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  return word.size() > 1 && is_letter(word.front()) && std::all_of(word.begin(), word.end(), [&](char c) {
           return is_letter(c) || (c >= '0' && c <= '9') || c == '_';
         });
}

/// Parses "7", "7/2", "7//3" or "-1/2/3" to the index of the vertex. Indices count from 1, negative ones from
/// the end. Those of texture and normal are ignored.
inline int obj_index(const mesh_source& from, std::string_view word, std::size_t vertex_count) {
  const auto count = static_cast<std::int64_t>(vertex_count);
  if (word.front() == '/') from.fail(word, "the number of a vertex");
  const auto named = from.number<std::int64_t>(word.substr(0, word.find('/')), "the number of a vertex");
  if (named == 0 || named > count || named < -count)
    from.fail(word, indexed("a vertex of the ", count, " above, from 1, or back from -1"));
  return static_cast<int>(named > 0 ? named - 1 : count + named);
}

inline void read_obj_vertex(mesh_source& from, polygons& to) {
  point<3> x;
  for (double& coordinate : x) coordinate = from.number<double>(from.word_in_line(), "a coordinate");
  if (to.vertices.size() == polygons::max_count) from.fail("v", "fewer vertices");
  for (auto word = from.word_in_line(); !word.empty() && word.front() != '#'; word = from.word_in_line())
    from.number<double>(word, "a weight or a colour");
  to.vertices.push_back(x);
}

inline void read_obj_face(mesh_source& from, polygons& to, std::vector<int>& corners) {
  const std::size_t line = from.line();
  corners.clear();
  std::string_view word = from.word_in_line();
  for (; !word.empty() && word.front() != '#'; word = from.word_in_line()) {
    if (corners.size() == polygons::max_corners) from.fail(word, "a polygon of fewer corners");
    corners.push_back(obj_index(from, word, to.vertices.size()));
  }
  if (corners.size() < 3) from.fail(word, "three corners or more");
  to.add(corners, line);
}

/// Skips any other line and lines joined by backslashes; an error if a vertex or face would be skipped.
inline void pass_over_obj_line(mesh_source& from, std::string_view word, polygons& to) {
  if (is_keyword(word, "l") || is_keyword(word, "p")) {
    ++to.not_polygons;
  } else if (!is_one_of(word, no_geometry_of_obj)) {
    if (is_one_of(word, not_read_of_obj) || !is_unknown_keyword(word))
      from.fail(word, "v, f or another keyword of a mesh; curves and free-form surfaces are not supported");
    to.skip_line(from.place_of(word));
  }
  while (from.next_line()) {
    word = from.word_in_line();
    if (is_keyword(word, "v") || is_keyword(word, "f"))
      from.fail(word, "no vertex or face behind a line that ends in a backslash; remove the backslash");
  }
}

inline void read_obj(const std::filesystem::path& path, polygons& to) {
  mesh_source from(path, true);
  from.lines().limit_zeros(1);  // the end of a C string
  to.place_name = "line ";
  std::vector<int> corners;
  for (std::string_view word = from.word(); !word.empty(); word = from.word()) {
    if (is_keyword(word, "v")) {
      read_obj_vertex(from, to);
      from.next_line();
    } else if (is_keyword(word, "f") || is_keyword(word, "fo")) {  // fo: obsolete form
      read_obj_face(from, to, corners);
      from.next_line();
    } else if (word.front() == '#') {
      from.next_line();  // a backslash in a comment joins nothing
    } else {
      pass_over_obj_line(from, word, to);
    }
  }
  to.skipped_bytes = from.lines().padding_size();
}

}  // namespace detail

/// Reads an OBJ file with the unit `metres_per_unit` (1e-3: millimetres). All objects and groups become one
/// mesh; a face may only refer to vertices above it. Lines with keywords of other programs are skipped and
/// counted. A file that was cut off between two lines is not detected. Throws std::invalid_argument with
/// file, line and expectation: not a regular file, not OBJ, an index out of range, coordinates that are not
/// finite, a polygon that crosses itself, no triangle with an area, a scale <= 0. For set-up.
inline mesh_file read_obj(const std::filesystem::path& path, double metres_per_unit = 1) {
  return detail::read_mesh_file(path, metres_per_unit, detail::read_obj);
}

}  // namespace passive_haptics
