/// Depth of a hand along a path that brakes cannot display.
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/design/path_point.hpp>
#include <passive_haptics/design/sink_slope.hpp>

#include <cmath>
#include <limits>

namespace passive_haptics {

/// Returns the minimum depth [m] of a hand that pushes with `push` [N] at the end of a path: the integral of
/// the sink slope over its length. 0 if it is held everywhere, infinite if it is held at no slope on some
/// part, or there is no result. path(u): path_point<M> at u in (0, 1), with end effectors along the wall;
/// called at the middles of `samples` >= 2 equal parts, else std::invalid_argument is thrown.
///
/// The slopes are those on the path, so the depth must be small compared with the device. A hand with a push
/// that falls with the depth sinks less. Later parts of the path do not lift the hand again.
template <class M, class Path>
typename M::scalar sink_depth(const M& mechanism, Path&& path, const hybrid_brakes<M>& brakes,
                              typename M::scalar push, int samples = 200) {
  using T = typename M::scalar;
  detail::refuse_unless(samples >= 2, "samples of a sink_depth", samples,
                        "2 or more: it takes the path's length from two places");
  T depth = T(0), slope_before = T(0), last_length = T(0);
  task_vector<M> x_before = task_vector<M>::Zero();
  for (int k = 0; k < samples; ++k) {
    const path_point<M> at = path((k + 0.5) / samples);
    const T slope = sink_slope(mechanism, at.q, at.direction, at.normal, brakes, push).slope;
    if (!std::isfinite(slope)) return std::numeric_limits<T>::infinity();
    const task_vector<M> x = mechanism.position(at.q);
    if (k > 0) {
      last_length = (x - x_before).norm();
      depth += (slope_before + slope) / T(2) * last_length;
      if (k == 1) depth += slope_before / T(2) * last_length;  // from the start to the first middle
    }
    slope_before = slope;
    x_before = x;
  }
  return depth + slope_before / T(2) * last_length;  // from the last middle to the end
}

/// Overload for brakes with these torque limits [N m].
template <class M, class Path>
typename M::scalar sink_depth(const M& mechanism, Path&& path, const brake_vector<M>& torque_limit,
                              typename M::scalar push, int samples = 200) {
  return passive_haptics::sink_depth(mechanism, path, hybrid_brakes<M>::with_limits(torque_limit), push,
                                     samples);
}

}  // namespace passive_haptics
