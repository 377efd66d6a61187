/// Meshes from PLY files, ASCII and binary.
#pragma once

#include <passive_haptics/scene/files/ply_header.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace passive_haptics {
namespace detail {

class ply_values {
 public:
  ply_values(mesh_source& from, const ply_header& header) : from_(from), header_(header) {}

  double real(ply_type t) {
    if (header_.is_text) return from_.number<double>(from_.word(), "a number");
    if (t == ply_type::float32) return from_.value<float>(header_.order);
    if (t == ply_type::float64) return from_.value<double>(header_.order);
    return static_cast<double>(whole(t));
  }
  std::int64_t whole(ply_type t) {
    if (header_.is_text) return from_.number<std::int64_t>(from_.word(), "a whole number");
    switch (t) {
      case ply_type::int8: return from_.value<std::int8_t>(header_.order);
      case ply_type::uint8: return from_.value<std::uint8_t>(header_.order);
      case ply_type::int16: return from_.value<std::int16_t>(header_.order);
      case ply_type::uint16: return from_.value<std::uint16_t>(header_.order);
      case ply_type::int32: return from_.value<std::int32_t>(header_.order);
      default: return from_.value<std::uint32_t>(header_.order);
    }
  }
  /// The length of a list; an error if the rest of the file is too short for it.
  std::size_t length(const ply_property& list) {
    const std::int64_t n = whole(list.count);
    const std::size_t least = header_.is_text ? 1 : size_of(list.type);
    if (n < 0 || static_cast<std::size_t>(n) > from_.left() / least)
      fail(indexed("a list of ", n, " values"), "0 or more, and no more than the file has");
    return static_cast<std::size_t>(n);
  }
  /// Skips a property. In a text its values may be any words ("-1.#IND").
  void skip(const ply_property& p) {
    for (std::size_t n = p.is_list() ? length(p) : 1; n > 0; --n) {
      if (!header_.is_text) real(p.type);
      else if (from_.word().empty()) from_.fail({}, "a value");
    }
  }
  /// Line of a text, or byte.
  std::size_t place() const { return header_.is_text ? from_.line() : from_.byte(); }
  [[noreturn]] void fail(const std::string& found, std::string_view expected) const {
    if (header_.is_text) from_.fail(found, expected);
    from_.fail_here("before it " + found, expected);
  }

 private:
  mesh_source& from_;
  const ply_header& header_;
};

inline void read_ply_vertices(ply_values& from, const ply_element& vertex, polygons& to) {
  to.vertices.resize(vertex.rows);
  for (point<3>& x : to.vertices)
    for (const ply_property& p : vertex.properties) {
      if (p.is_list() || p.name.size() != 1 || p.name[0] < 'x' || p.name[0] > 'z') from.skip(p);
      else x[p.name[0] - 'x'] = from.real(p.type);
    }
}

inline void read_ply_polygon(ply_values& from, const ply_property& list, std::size_t vertices, polygons& to,
                             std::vector<int>& corners) {
  corners.resize(from.length(list));
  const std::size_t place = from.place();
  if (corners.size() > polygons::max_corners)
    from.fail(indexed("a polygon of ", corners.size(), " corners"), "at most 1000");
  for (int& corner : corners) {
    const std::int64_t i = from.whole(list.type);
    if (i < 0 || static_cast<std::size_t>(i) >= vertices)
      from.fail(indexed("vertex ", i, ""),
                indexed("0 or more and less than ", vertices, ", as many as there are"));
    corner = static_cast<int>(i);
  }
  to.add(corners, place);
}

inline bool is_corner_list(const ply_property& p) {
  return p.name == "vertex_indices" || p.name == "vertex_index";
}

/// Checks the required properties, and that the file is long enough for all rows.
inline void check_ply_header(const mesh_source& from, const ply_header& header) {
  const auto refuse_unless = [&](bool holds, const char* expected) {
    if (!holds)
      fail_mesh_file(from.path(),
                     std::string("the header is not that of a mesh: expected ").append(expected));
  };
  const ply_element* const vertex = header.find("vertex");
  refuse_unless(vertex != nullptr && vertex->rows <= polygons::max_count,
                "'element vertex' and how many there are");
  for (const char* axis : {"x", "y", "z"})
    refuse_unless(vertex->find(axis) != nullptr && !vertex->find(axis)->is_list(),
                  "properties x, y and z of the vertices");
  const ply_element* const face = header.find("face");
  refuse_unless(face != nullptr, "'element face' and how many there are");
  const ply_element* const strips = header.find("tristrips");
  refuse_unless(strips == nullptr || strips->rows == 0, "faces; triangle strips are not supported");
  int lists = 0;
  for (const ply_property& p : face->properties)
    lists += is_corner_list(p) && p.is_list() && is_whole(p.type);
  refuse_unless(lists == 1, "'property list uchar int vertex_indices' of the faces");
  for (const ply_element& e : header.elements) {
    const std::size_t least = e.min_row_size(header.is_text);
    if (e.rows > 0 &&
        (least == 0 || e.rows > (from.left() + 1) / least))  // the last row may have no end of line
      fail_mesh_file(from.path(),
                     indexed("element " + e.name + " has ", e.rows, " rows of ")
                         .append(indexed("", least, " bytes or more: expected "))
                         .append(indexed("no more than the ", from.left(), " bytes that follow the header")));
  }
}

inline void read_ply(const std::filesystem::path& path, polygons& to) {
  mesh_source from(path);
  const ply_header header = read_ply_header(from, to);
  check_ply_header(from, header);
  const std::size_t vertices = header.find("vertex")->rows;
  to.place_name = header.is_text ? "line " : "byte ";
  ply_values values(from, header);
  std::vector<int> corners;
  for (const ply_element& e : header.elements) {
    if (e.name == "vertex") {
      read_ply_vertices(values, e, to);
      continue;
    }
    for (std::size_t row = 0; row < e.rows; ++row)
      for (const ply_property& p : e.properties) {
        if (e.name == "face" && is_corner_list(p)) read_ply_polygon(values, p, vertices, to, corners);
        else values.skip(p);
      }
    if (e.name == "edge") to.not_polygons += e.rows;
  }
  if (header.is_text) {
    if (const auto word = from.word(); !word.empty())
      from.fail(word, "the end of the file, as the header says");
    to.skipped_bytes = from.lines().padding_size();
  } else if (from.only_padding_is_left()) {
    to.skipped_bytes = from.left();
  } else {
    from.fail_here(indexed("", from.left(), " bytes more"), "the end of the file, as the header says");
  }
}

}  // namespace detail

/// Reads a PLY file with the unit `metres_per_unit` (1e-3: millimetres), in double precision if the file has
/// it. Other elements and properties are skipped, and padding after the data. Throws std::invalid_argument
/// with file, place and expectation: as read_obj, or cut off. For set-up.
inline mesh_file read_ply(const std::filesystem::path& path, double metres_per_unit = 1) {
  return detail::read_mesh_file(path, metres_per_unit, detail::read_ply);
}

}  // namespace passive_haptics
