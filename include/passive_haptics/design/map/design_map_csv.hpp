/// Design maps as text for a spreadsheet, NumPy or gnuplot.
#pragma once

#include <passive_haptics/design/map/design_map.hpp>

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

namespace passive_haptics {

/// Returns comma-separated values, one row per point, after a row of names with units:
///
///     x1 [m],..., q1,..., outcome, display, gamma [rad], drag [1], max force [N], sink slope [1], ...
///
/// Numbers are exact when read again. Throws std::invalid_argument unless the map is that of the points.
template <class M>
std::string to_csv(const task_points<M>& points, const design_map<M>& map) {
  using T = typename M::scalar;
  detail::refuse_unless(points.size() == map.size(), "number of points", points.size(),
                        detail::indexed("", map.size(), ", the size of their design_map"));
  std::string text;
  for (int i = 1; i <= M::task_dimension; ++i) text.append(detail::indexed("x", i, " [m],"));
  for (int i = 1; i <= M::dof; ++i) text.append(detail::indexed("q", i, ","));
  text.append("outcome,display,gamma [rad],drag [1],max force [N],sink slope [1],isotropy [1]\n");
  const auto append_number = [&](T x) {
    std::array<char, 64> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), x).ptr;
    text.append(digits.data(), end);
  };
  const auto append_all = [&](const auto& x) {
    for (const T each : x) {
      append_number(each);
      text.push_back(',');
    }
  };
  for (std::size_t k = 0; k < map.size(); ++k) {
    append_all(points.position(k));
    append_all(points[k].q);
    text.append("\"").append(to_string(map.outcome[k])).append("\",").append(to_string(map.display[k]));
    for (const T figure :
         {std::acos(map.cosine[k]), map.drag[k], map.max_force[k], map.sink_slope[k], map.isotropy[k]}) {
      text.push_back(',');
      append_number(figure);
    }
    text.push_back('\n');
  }
  return text;
}

}  // namespace passive_haptics
