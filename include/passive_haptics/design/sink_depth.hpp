/// @file
/// How deep a hand sinks along a path that brakes cannot display.
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/design/path_point.hpp>
#include <passive_haptics/design/sink_slope.hpp>

#include <cmath>
#include <limits>

namespace passive_haptics {

/// Depth [m] to which a hand that pushes with `push` [N] sinks on the way along a path, at least: the
/// integral of the sink slope over the length of the path. 0 where it is held everywhere, infinite where it
/// is held at no slope on some part of the path, or has no result there.
///
/// path(u) returns the path_point<M> at u in (0, 1), and its end effectors follow the wall: their distances
/// are the path's length. Called at the middles of `samples` >= 2 equal parts, by the trapezoidal rule.
///
/// The slopes are those on the path, not at the depth: it holds as long as the depth is small beside the
/// device. A hand whose push falls with the depth sinks less. Where more is held, no hand rises again.
/// Throws std::invalid_argument for less than 2 samples. Cost: a sink_slope and a position for each.
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

/// The depth of brakes of these torque limits [N m].
template <class M, class Path>
typename M::scalar sink_depth(const M& mechanism, Path&& path, const brake_vector<M>& torque_limit,
                              typename M::scalar push, int samples = 200) {
  switchable_brakes<M> brakes;
  brakes.torque_limit = torque_limit;
  return passive_haptics::sink_depth(mechanism, path, hybrid_brakes<M>(brakes), push, samples);
}

}  // namespace passive_haptics
