// A cube, and any mesh in each format.
#pragma once

#include "../../property/sample_meshes.hpp"

#include <passive_haptics/scene/files/obj.hpp>
#include <passive_haptics/scene/files/ply.hpp>
#include <passive_haptics/scene/files/stl.hpp>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <string>

namespace mesh_files {

namespace ph = passive_haptics;
using mesh = ph::mesh_parameters<3>;

inline mesh cube() { return sample_meshes::box<3>({0, 0, 0}, {1, 2, 3}); }

template <class T>
void append(std::string& bytes, T value, std::endian order = std::endian::little) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  if (order != std::endian::native) std::reverse(raw, raw + sizeof value);
  bytes.append(raw, sizeof value);
}

inline std::string ascii_stl(const mesh& m) {
  std::ostringstream text;
  text.precision(17);
  text << "solid part of a thing\n";
  for (std::size_t f = 0; f < m.facets.size(); ++f) {
    text << "facet normal nan 0 0\nouter loop\n";
    for (const auto& c : m.corners(f)) text << "vertex " << c[0] << " " << c[1] << " " << c[2] << "\n";
    text << "endloop\nendfacet\n";
  }
  text << "endsolid part of a thing\n";
  return text.str();
}

inline std::string binary_stl(const mesh& m, const std::string& title = "") {
  std::string bytes = title + std::string(80 - title.size(), ' ');
  append(bytes, static_cast<std::uint32_t>(m.facets.size()));
  for (std::size_t f = 0; f < m.facets.size(); ++f) {
    for (int i = 0; i < 3; ++i) append(bytes, 0.0f);
    for (const auto& c : m.corners(f))
      for (const double x : c) append(bytes, static_cast<float>(x));
    append(bytes, std::uint16_t(0));
  }
  return bytes;
}

inline std::string obj(const mesh& m) {
  std::ostringstream text;
  text.precision(17);
  for (const auto& v : m.vertices) text << "v " << v[0] << " " << v[1] << " " << v[2] << "\n";
  for (const auto& f : m.facets) text << "f " << f[0] + 1 << " " << f[1] + 1 << " " << f[2] + 1 << "\n";
  return text.str();
}

inline std::string ply_head(const std::string& format, const mesh& m, const std::string& index = "int") {
  return "ply\nformat " + format + " 1.0\ncomment a cube\nelement vertex " +
         std::to_string(m.vertices.size()) +
         "\nproperty double x\nproperty double y\nproperty double z\nproperty uchar red\nelement face " +
         std::to_string(m.facets.size()) + "\nproperty list uchar " + index + " vertex_indices\nend_header\n";
}

inline std::string ascii_ply(const mesh& m) {
  std::ostringstream text;
  text.precision(17);
  text << ply_head("ascii", m);
  for (const auto& v : m.vertices) text << v[0] << " " << v[1] << " " << v[2] << " 7\n";
  for (const auto& f : m.facets) text << "3 " << f[0] << " " << f[1] << " " << f[2] << "\n";
  return text.str();
}

inline std::string binary_ply(const mesh& m, std::endian order = std::endian::little) {
  std::string bytes =
      ply_head(order == std::endian::little ? "binary_little_endian" : "binary_big_endian", m);
  for (const auto& v : m.vertices) {
    for (const double x : v) append(bytes, x, order);
    append(bytes, std::uint8_t(7));
  }
  for (const auto& f : m.facets) {
    append(bytes, std::uint8_t(3));
    for (const int i : f) append(bytes, i, order);
  }
  return bytes;
}

}  // namespace mesh_files
