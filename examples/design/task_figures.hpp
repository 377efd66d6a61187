// What a device does over its whole workspace: the figures of design maps over 16 directions of motion.
#pragma once

#include <passive_haptics/design/map/design_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

namespace design {

namespace ph = passive_haptics;

using plane = ph::vector<double, 2>;

// Brakes of 1 N m, and a hand that pushes into the wall
inline constexpr double push = 2;  // [N]

// A device, its inverse, and its workspace.
template <class M, class Inverse>
struct candidate {
  M mechanism;
  Inverse inverse;
  ph::task_grid<double, 2> where;

  // Its points for this direction of motion along a wall on the left
  ph::task_points<M> points(const plane& along) const {
    return ph::points_of(mechanism, where, inverse, along, plane(along[1], -along[0]));
  }
};
template <class M, class Inverse>
candidate(M, Inverse, ph::task_grid<double, 2>) -> candidate<M, Inverse>;

// Shares and means over all reached points, in all directions.
struct task_figures {
  double exact = 0, approximate = 0, none = 0;  // shares [1]
  double drag = 0;                              // median over displayed forces [1]
  double max_force = 0;                         // mean [N]
  double held = 0, sinking = 0, lost = 0;       // shares: slope 0, finite, infinite [1]
  double sink_slope = 0;                        // median over sinking points [1]
  double isotropy = 0;                          // mean [1]
};

inline double median(std::vector<double>& values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

template <class M, class Inverse>
task_figures over_task(const candidate<M, Inverse>& device) {
  constexpr int directions = 16;
  task_figures mean;
  std::vector<double> drags, slopes;
  double count = 0;
  ph::design_map<M> map;
  for (int i = 0; i < directions; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.5) / directions;
    map.assign(device.mechanism, device.points({std::cos(angle), std::sin(angle)}),
               ph::switchable_brakes<M>(), push);
    for (std::size_t k = 0; k < map.size(); ++k) {
      const auto at = map[k];
      if (at.outcome != ph::status::ok) continue;
      ++count;
      mean.exact += at.display == ph::display_class::exact;
      mean.approximate += at.display == ph::display_class::approximate;
      mean.none += !is_displayed(at.display);
      if (is_displayed(at.display)) drags.push_back(at.drag);
      mean.max_force += at.max_force;
      mean.held += at.sink_slope == 0;
      mean.lost += std::isinf(at.sink_slope);
      if (at.sink_slope > 0 && std::isfinite(at.sink_slope)) slopes.push_back(at.sink_slope);
      mean.isotropy += at.isotropy;
    }
  }
  for (double* share :
       {&mean.exact, &mean.approximate, &mean.none, &mean.max_force, &mean.held, &mean.lost, &mean.isotropy})
    *share /= count;
  mean.sinking = 1 - mean.held - mean.lost;
  mean.drag = median(drags);
  mean.sink_slope = median(slopes);
  return mean;
}

}  // namespace design
