/// @file
/// Four boxes side by side: what a node of a tree of boxes is looked at with.
#pragma once

#include <passive_haptics/scene/bounds/bounding_box.hpp>

#include <limits>

namespace passive_haptics {

/// Four boxes in float side by side, looked at together. Each is grown by what its arithmetic may lose: a
/// bound all the same.
template <int D>
struct four_outer_boxes {
  using four = Eigen::Array<float, 4, 1>;  ///< One value of each box.

  Eigen::Array<float, 4, D> lower;  ///< A column for each axis [m].
  Eigen::Array<float, 4, D> upper;  ///< A column for each axis [m].

  /// Makes box k, 0 <= k < 4, hold b, whose coordinates are up to `scale` [m].
  void set(int k, const bounding_box<D>& b, double scale) {
    const double margin = 4 * epsilon * scale;
    unrolled<D>([&](auto i) {
      lower(k, i) = static_cast<float>(b.lower[i] - margin);
      upper(k, i) = static_cast<float>(b.upper[i] + margin);
    });
  }

  /// Not more than the squares of the distances from x to the boxes [m^2], and less by rounding only; 0
  /// inside.
  four squared_distances(const vector<float, D>& x) const {
    constexpr float largest = std::numeric_limits<float>::max();
    four sum = four::Zero();
    unrolled<D>([&](auto i) { sum += (lower.col(i) - x[i]).max(x[i] - upper.col(i)).max(0.f).square(); });
    return (1 - 8 * epsilon) * sum.min(largest);
  }

 private:
  static constexpr float epsilon = std::numeric_limits<float>::epsilon();
};

/// How far each of four boxes is from x [m^2]: what limits a search for what is near.
template <int D>
auto squared_distance_from(const point<D>& x) {
  const vector<float, D> from = x.template cast<float>();
  return [from](const four_outer_boxes<D>& boxes) { return boxes.squared_distances(from); };
}

}  // namespace passive_haptics
