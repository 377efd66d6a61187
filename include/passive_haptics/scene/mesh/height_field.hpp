/// Terrain: heights over a regular grid.
#pragma once

#include <passive_haptics/core/nth.hpp>
#include <passive_haptics/scene/mesh/mesh.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace passive_haptics {

/// Heights over the points (i spacing_x, j spacing_y) of a grid from `origin`; free above.
struct height_field_parameters {
  int columns = 0;       ///< Points along x, 2 or more.
  int rows = 0;          ///< Points along y, 2 or more.
  double spacing_x = 0;  ///< Between columns [m], > 0.
  double spacing_y = 0;  ///< Between rows [m], > 0.
  /// Height z over the origin [m], row by row: column i and row j is [j columns + i].
  std::vector<double> heights;
  point<3> origin{0, 0, 0};  ///< Position of column 0 and row 0 at height 0 [m].

  static constexpr const char* grid = "2 or more, and at most 2^31 triangles in all";  ///< In errors.
  static constexpr const char* type_name = "a height_field";                           ///< In errors.
  static constexpr auto members() {
    using p = height_field_parameters;
    return member_table(member("columns", &p::columns, "", range::at_least(2).as(grid)),
                        member("rows", &p::rows, "", range::at_least(2).as(grid)),
                        member("spacing_x", &p::spacing_x, "m", range::positive),
                        member("spacing_y", &p::spacing_y, "m", range::positive),
                        member("origin", &p::origin, "m", range::finite));
  }
  /// Requires one finite height per point, and no more than a mesh can have.
  std::string rules() const {
    const auto count = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    if (count > std::numeric_limits<int>::max() / 2)
      return detail::error_text("columns x rows of a height_field", count, grid);
    if (heights.size() != count)
      return detail::error_text("number of heights of a height_field", heights.size(),
                                detail::indexed("columns x rows, ", count, ""));
    const auto finite = [](double z) { return std::isfinite(z); };
    const auto bad = std::find_if_not(heights.begin(), heights.end(), finite);
    if (bad == heights.end()) return {};
    return detail::error_text(detail::indexed("heights[", bad - heights.begin(), "] of a height_field [m]"),
                              *bad, "a finite number");
  }
};

/// Returns two triangles for each cell, cut along the diagonal with the smaller difference in height. The
/// surface is open: use mesh_surface. Throws std::invalid_argument with the text of validate(p).
template <int D = 3>
mesh_parameters<D> height_field(const height_field_parameters& p) {
  require_valid(p);
  mesh_parameters<D> m;
  m.vertices.reserve(p.heights.size());
  for (int j = 0; j < p.rows; ++j) {
    for (int i = 0; i < p.columns; ++i)
      m.vertices.push_back(p.origin +
                           point<D>(i * p.spacing_x, j * p.spacing_y, p.heights[m.vertices.size()]));
  }
  const auto z = [&](int k) { return nth(p.heights, k); };
  for (int j = 0; j + 1 < p.rows; ++j) {
    for (int i = 0; i + 1 < p.columns; ++i) {
      // Counterclockwise from above
      const int a = j * p.columns + i, b = a + 1, c = b + p.columns, d = a + p.columns;
      const bool from_a_to_c = std::abs(z(a) - z(c)) <= std::abs(z(b) - z(d));
      m.facets.push_back({a, b, from_a_to_c ? c : d});
      m.facets.push_back({from_a_to_c ? a : b, c, d});
    }
  }
  return m;
}

}  // namespace passive_haptics
