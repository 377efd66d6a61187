/// @file
/// Meshes from STL files, ASCII and binary.
#pragma once

#include <passive_haptics/scene/files/mesh_source.hpp>

#include <array>
#include <bit>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace passive_haptics {
namespace detail {

/// Three vertices of its own for each triangle.
inline void add_loose_triangle(const std::array<point<3>, 3>& corners, polygons& to) {
  const int first = static_cast<int>(to.vertices.size());
  to.vertices.insert(to.vertices.end(), corners.begin(), corners.end());
  to.add(std::array{first, first + 1, first + 2});
}

inline constexpr std::size_t stl_head = 84, stl_triangle = 50;  // [bytes]

/// How many triangles a binary file says that it has.
inline std::size_t stl_count(mesh_source& from) {
  from.seek(stl_head - sizeof(std::uint32_t));
  return from.value<std::uint32_t>(std::endian::little);
}

/// 80 bytes of a title, the number of triangles, and of each normal, corners and two bytes.
inline void read_binary_stl(mesh_source& from, polygons& to) {
  const std::size_t count = stl_count(from);
  to.vertices.reserve(3 * count);
  for (std::size_t i = 0; i < count; ++i) {
    from.seek(stl_head + i * stl_triangle + 3 * sizeof(float));
    std::array<point<3>, 3> corners;
    for (auto& corner : corners)
      for (double& x : corner) x = from.value<float>(std::endian::little);
    add_loose_triangle(corners, to);
  }
}

/// "solid NAME", facets, "endsolid NAME", as often as there are solids.
inline void read_ascii_stl(mesh_source& from, polygons& to) {
  const auto expect = [&](std::string_view word) {
    if (const auto found = from.word(); found != word)
      from.fail(found, std::string("'").append(word).append("'"));
  };
  for (std::string_view word = from.word(); !word.empty(); word = from.word()) {
    if (word != "solid") from.fail(word, "'solid', or the end of the file");
    from.next_line();
    for (word = from.word(); word != "endsolid"; word = from.word()) {
      if (word != "facet") from.fail(word, "'facet' or 'endsolid'");
      expect("normal");
      for (int i = 0; i < 3; ++i) from.word();  // the corners say it better
      expect("outer");
      expect("loop");
      std::array<point<3>, 3> corners;
      for (auto& corner : corners) {
        expect("vertex");
        for (double& x : corner) x = from.number<double>(from.word(), "a number");
      }
      expect("endloop");
      expect("endfacet");
      add_loose_triangle(corners, to);
    }
    from.next_line();
  }
}

inline void read_stl(const std::filesystem::path& path, polygons& to) {
  mesh_source from(path);
  const std::string_view bytes = from.bytes();
  const bool has_head = bytes.size() >= stl_head;
  const std::size_t size = has_head ? stl_head + stl_triangle * stl_count(from) : stl_head;
  from.seek(0);
  if (bytes.size() / stl_triangle > polygons::max_count / 3)
    from.fail_here("a file that large", "fewer triangles");
  if (has_head && bytes.size() == size) return read_binary_stl(from, to);
  if (bytes.substr(0, 5) == "solid") return read_ascii_stl(from, to);
  from.fail_here(indexed("a file of ", bytes.size(), " bytes that does not begin with 'solid'"),
                 indexed("", size, " bytes of a binary file; it was cut off, or is no STL"));
}

}  // namespace detail

/// The mesh of an STL file whose unit is `metres_per_unit` (1e-3: millimetres). Its normals are not read:
/// which side is free follows from the order of the corners. Coordinates of binary files have 24 bits.
///
/// Throws std::invalid_argument that names file and line, or byte, and what was expected: no regular file,
/// not STL, cut off, coordinates that are not finite, no triangle with an area, a scale that is not positive.
/// For set-up, never for a control cycle.
inline mesh_file read_stl(const std::filesystem::path& path, double metres_per_unit = 1) {
  return detail::read_mesh_file(path, metres_per_unit, detail::read_stl);
}

}  // namespace passive_haptics
