/// Four boxes in SIMD lanes, one node of a tree of boxes.
#pragma once

#include <passive_haptics/core/linear/lane_products.hpp>
#include <passive_haptics/core/nth.hpp>
#include <passive_haptics/scene/bounds/bounding_box.hpp>

#include <array>
#include <limits>

namespace passive_haptics {

/// Four boxes in the lanes of T. Each is enlarged by the rounding of its coordinates.
template <int D, class T = float>
struct four_outer_boxes {
  using four = lanes<T, 4>;  ///< One value of each box.

  std::array<four, static_cast<std::size_t>(D)> lower;  ///< Lower ends by axis [m].
  std::array<four, static_cast<std::size_t>(D)> upper;  ///< Upper ends by axis [m].

  four_outer_boxes() = default;
  /// Four boxes that contain the given ones, with coordinates up to `scale` [m].
  four_outer_boxes(const std::array<bounding_box<D>, 4>& boxes, double scale) {
    const double margin = 4 * epsilon * scale;
    const auto box = [&](int k) -> const bounding_box<D>& { return nth(boxes, k); };
    unrolled<D>([&](auto i) {
      const auto axis = static_cast<std::size_t>(i);
      lower[axis] = four([&](int k) { return static_cast<T>(box(k).lower[i] - margin); });
      upper[axis] = four([&](int k) { return static_cast<T>(box(k).upper[i] + margin); });
    });
  }

  /// Squared distances from x to the boxes [m^2], with relative error `rounding`; 0 inside.
  four squared_distances(const vector<T, D>& x) const {
    four sum(T(0));
    unrolled<D>([&](auto i) {
      const auto axis = static_cast<std::size_t>(i);
      const four outside = max(max(lower[axis] - x[i], x[i] - upper[axis]), T(0));
      sum = sum + outside * outside;
    });
    return sum;
  }

  static constexpr T rounding = 8 * std::numeric_limits<T>::epsilon();  ///< Relative error of a distance.

 private:
  static constexpr T epsilon = std::numeric_limits<T>::epsilon();
};

/// Returns the bound of a search near x: the squared distances of four boxes from x [m^2].
template <int D>
auto squared_distance_from(const point<D>& x) {
  const vector<float, D> from = x.template cast<float>();
  return [from](const four_outer_boxes<D>& boxes) { return boxes.squared_distances(from); };
}

}  // namespace passive_haptics
