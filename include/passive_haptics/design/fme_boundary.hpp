/// Outlines of passive FMEs of two planar brakes, for drawing.
#pragma once

#include <passive_haptics/brake/passive_fme.hpp>
#include <passive_haptics/core/parameters.hpp>

#include <cmath>
#include <numbers>
#include <vector>

namespace passive_haptics {

/// Closed outline [N] of the passive FME of one region: the origin, the arc of the ellipse G (cos a, sin a)
/// over the region's quadrant in `segments` chords, and the origin again. G (2 x 2) from reference_forces.
/// Throws std::invalid_argument unless there are 1 to 1 million segments. Allocates.
template <class T>
std::vector<vector<T, 2>> passive_fme_outline(const matrix<T, 2, 2>& G, const torque_signs<2>& region,
                                              int segments = 32) {
  detail::refuse_unless(segments >= 1 && segments <= 1'000'000, "segments of a passive_fme_outline", segments,
                        "1 to 1000000");
  std::vector<vector<T, 2>> outline{vector<T, 2>::Zero()};
  for (int k = 0; k <= segments; ++k) {
    const T a = std::numbers::pi_v<T> / T(2) * static_cast<T>(k) / static_cast<T>(segments);
    const vector<T, 2> t(static_cast<T>(region[0]) * std::cos(a), static_cast<T>(region[1]) * std::sin(a));
    outline.push_back(G * t);
  }
  outline.push_back(vector<T, 2>::Zero());
  return outline;
}

/// Closed outline [N] of the forces of brakes with these limits [N m] in one region, a parallelogram.
template <class T>
std::vector<vector<T, 2>> torque_box_outline(const matrix<T, 2, 2>& G, const torque_signs<2>& region,
                                             const vector<T, 2>& limit) {
  const vector<T, 2> a = static_cast<T>(region[0]) * limit[0] * G.col(0);
  const vector<T, 2> b = static_cast<T>(region[1]) * limit[1] * G.col(1);
  return {vector<T, 2>::Zero(), a, a + b, b, vector<T, 2>::Zero()};
}

}  // namespace passive_haptics
