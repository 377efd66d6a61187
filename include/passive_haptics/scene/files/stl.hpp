/// Meshes from STL files, ASCII and binary.
#pragma once

#include <passive_haptics/scene/files/mesh_source.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace passive_haptics {
namespace detail {

inline void add_loose_triangle(const std::array<point<3>, 3>& corners, std::size_t place, polygons& to) {
  const int first = static_cast<int>(to.vertices.size());
  to.vertices.insert(to.vertices.end(), corners.begin(), corners.end());
  to.add(std::array{first, first + 1, first + 2}, place);
}

inline constexpr std::size_t stl_head = 84, stl_triangle = 50;  // [bytes]

inline std::size_t stl_count(mesh_source& from) {
  from.seek(stl_head - sizeof(std::uint32_t));
  return from.value<std::uint32_t>(std::endian::little);
}

/// Skips bytes after the triangles of a binary file; an error if they may be triangles.
inline void check_end_of_stl(mesh_source& from, std::size_t count, polygons& to) {
  const std::size_t size = stl_head + count * stl_triangle, found = from.bytes().size();
  from.seek(std::min(size, found));
  if (found < size)
    from.fail_here("the file ends", indexed(indexed("", size, " bytes, those of "), count,
                                            " triangles; it was cut off, or is not an STL file"));
  const std::size_t more = from.left() / stl_triangle;
  if (more > 0 && (more > count || from.left() % stl_triangle == 0) && !from.only_padding_is_left()) {
    from.seek(stl_head - sizeof(std::uint32_t));
    from.fail_here(indexed("a count of ", count, " triangles"),
                   indexed("", count + more, ", for which the file has bytes; write the file again"));
  }
  to.skipped_bytes = from.left();
}

/// Format: 80 bytes of title, the number of triangles, and for each a normal, corners and two bytes.
inline void read_binary_stl(mesh_source& from, polygons& to) {
  const std::size_t count = stl_count(from);
  check_end_of_stl(from, count, to);
  to.vertices.reserve(3 * count);
  to.place_name = "byte ";
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t begin = stl_head + i * stl_triangle;
    from.seek(begin + 3 * sizeof(float));
    std::array<point<3>, 3> corners;
    for (auto& corner : corners)
      for (double& x : corner) x = from.value<float>(std::endian::little);
    add_loose_triangle(corners, begin, to);
  }
}

/// Reads a facet after its first word: "normal X Y Z outer loop ... endfacet". Ignores the normal.
inline void read_ascii_facet(mesh_source& from, polygons& to) {
  const auto expect = [&](std::string_view keyword, std::string_view word) {
    if (!is_keyword(word, keyword)) from.fail(word, quoted(keyword));
  };
  const auto expect_end = [&](std::string_view of) {  // "endloop" or "end loop"
    const std::string_view word = from.word();
    expect(is_keyword(word, "end") ? "end" : of, word);
    if (is_keyword(word, "end")) expect(of.substr(3), from.word());
  };
  const std::size_t line = from.line();
  expect("normal", from.word());
  std::string_view word = from.word();
  for (int i = 0; i < 3 && !is_keyword(word, "outer"); ++i) word = from.word();
  expect("outer", word);
  expect("loop", from.word());
  std::array<point<3>, 3> corners;
  for (auto& corner : corners) {
    expect("vertex", from.word());
    for (double& x : corner) x = from.number<double>(from.word(), "a number");
  }
  expect_end("endloop");
  expect_end("endfacet");
  add_loose_triangle(corners, line, to);
}

/// Reads one or more "solid NAME", facets, "endsolid NAME", with comments and colours in between.
inline void read_ascii_stl(mesh_source& from, polygons& to) {
  to.place_name = "line ";
  const auto next = [&] {
    std::string_view word = from.word();
    while (is_keyword(word, "color") || word.starts_with('#') || word.starts_with(';')) {
      to.skip_line(from.place_of(word));
      from.next_line();
      word = from.word();
    }
    return word;
  };
  std::string_view word = next();
  if (!is_keyword(word, "solid")) from.fail(word, "'solid'; it was cut off, or is not an STL file");
  while (!word.empty()) {
    from.next_line();
    for (word = next(); !is_keyword(word, "endsolid"); word = next()) {
      if (is_keyword(word, "end") && is_keyword(from.word_in_line(), "solid")) break;
      if (!is_keyword(word, "facet")) from.fail(word, "'facet' or 'endsolid'");
      read_ascii_facet(from, to);
    }
    from.next_line();
    word = next();
    if (!word.empty() && !is_keyword(word, "solid")) from.fail(word, "'solid', or the end of the file");
  }
  to.skipped_bytes = from.lines().padding_size();
}

inline void read_stl(const std::filesystem::path& path, polygons& to) {
  mesh_source from(path);
  const std::string_view bytes = from.bytes();
  if (bytes.size() / stl_triangle > polygons::max_count / 3)
    from.fail_here("a file that large", "fewer triangles");
  const bool has_head = bytes.size() >= stl_head;
  const bool is_whole = has_head && bytes.size() == stl_head + stl_triangle * stl_count(from);
  // A text has zero bytes only at its end; a count below 2^24 has one
  const bool has_count = has_head && bytes.substr(0, stl_head).find('\0') != bytes.npos;
  if (is_whole || has_count) return read_binary_stl(from, to);
  read_ascii_stl(from, to);
}

}  // namespace detail

/// Reads an ASCII or binary STL file with the unit `metres_per_unit` (1e-3: millimetres). Normals are
/// ignored: the order of the corners defines the free side. Comments, colours and bytes after the triangles
/// are skipped and counted. Throws std::invalid_argument with file, place and expectation: as read_obj, cut
/// off, or a wrong count. For set-up.
inline mesh_file read_stl(const std::filesystem::path& path, double metres_per_unit = 1) {
  return detail::read_mesh_file(path, metres_per_unit, detail::read_stl);
}

}  // namespace passive_haptics
