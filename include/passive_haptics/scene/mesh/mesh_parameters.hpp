/// Vertices and facets of a mesh.
#pragma once

#include <passive_haptics/core/finite.hpp>
#include <passive_haptics/core/nth.hpp>
#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/scene/mesh/mesh_facet.hpp>

#include <array>
#include <string>
#include <vector>

namespace passive_haptics {

/// A polyline (D = 2: segments) or a triangle mesh (D = 3); mesh_facet defines the free side. Vertices in the
/// same place are merged, so that loose triangles (STL) are connected.
template <int D>
struct mesh_parameters {
  std::vector<point<D>> vertices;                                    ///< [m]; some may be unused.
  std::vector<std::array<int, static_cast<std::size_t>(D)>> facets;  ///< Indices of vertices.

  /// Corners of facet i, with valid indices.
  std::array<point<D>, static_cast<std::size_t>(D)> corners(std::size_t i) const {
    std::array<point<D>, static_cast<std::size_t>(D)> c;
    for (std::size_t k = 0; k < c.size(); ++k) c[k] = nth(vertices, facets[i][k]);
    return c;
  }
};

/// Triangles with a height by longest edge up to this count as without area: their normal is rounding.
inline constexpr double min_slenderness = 1e-10;

/// Returns an error text for the first wrong facet or vertex; empty if there is none.
template <int D>
std::string validate(const mesh_parameters<D>& p) {
  if (p.facets.empty()) return "a mesh has no facets: expected one or more";
  for (std::size_t i = 0; i < p.vertices.size(); ++i) {
    if (!all_finite(p.vertices[i]))
      return check_value(detail::indexed("vertices[", i, "]").c_str(), p.vertices[i], "m", range::finite,
                         "a mesh");
  }
  for (std::size_t i = 0; i < p.facets.size(); ++i) {
    const auto name = [i](const char* what) {
      return detail::indexed("facet ", i, " of a mesh: ").append(what);
    };
    for (const int v : p.facets[i]) {
      if (v >= 0 && static_cast<std::size_t>(v) < p.vertices.size()) continue;
      return detail::error_text(name("index of a vertex"), v,
                                detail::indexed("0 or more and less than ", p.vertices.size(), ""));
    }
    const double slenderness = detail::slenderness(p.corners(i));
    if (!(slenderness > min_slenderness))
      return detail::error_text(name("height by longest edge"), slenderness,
                                "> 1e-10; remove the facet, without_slivers() does");
  }
  return {};
}

/// Returns the mesh without facets that have no area. The mesh becomes open if such a facet joined an edge to
/// two shorter ones. All indices must be valid.
template <int D>
mesh_parameters<D> without_slivers(mesh_parameters<D> p) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < p.facets.size(); ++i) {
    if (detail::slenderness(p.corners(i)) > min_slenderness) p.facets[kept++] = p.facets[i];
  }
  p.facets.resize(kept);
  return p;
}

}  // namespace passive_haptics
