/// @file
/// Memory of one contact under velocity_direct_control, and the way that the handle was seen to make.
#pragma once

#include <passive_haptics/control/laws/velocity/velocity_direct_control_parameters.hpp>
#include <passive_haptics/core/nth.hpp>
#include <passive_haptics/scene/shape.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace passive_haptics {

/// The handle's position, from cycle to cycle.
struct seen_position {
  std::array<double, 3> before{};  ///< In the cycle before [m].

  /// The distance to x, which is the position before from now on [m].
  template <int D>
  double move_to(const point<D>& x) {
    double square = 0;
    for (int i = 0; i < D; ++i) {
      const double step = x[i] - nth(before, i);
      square += step * step;
      nth(before, i) = x[i];
    }
    return std::sqrt(square);
  }
};

/// Memory of one contact.
///
/// **Jumps of the depth.** A count of the encoders moves the handle, and the depth with it, more than its
/// velocity explains. Depth is a distance, so in one cycle a count changes it by no more than the handle was
/// seen to move. All beyond comes from the scene, such as another face, a wall that was moved, or a new
/// sample of a slow scene, and does not make the handle rest deeper.
struct velocity_contact_state {
  double depth = std::numeric_limits<double>::quiet_NaN();  ///< In the cycle before [m]; NaN if none.
  double jump = 0;  ///< The largest jump of the depth by a count, slowly forgotten [m].
  double bias = 0;  ///< b [N]

  /// The depth of rest [m], after a cycle of duration dt [s] in which the handle moved by `moved` [m] and has
  /// the normal velocity `outward` [m/s].
  double rest_depth(double depth_now, double outward, double moved, double dt,
                    const velocity_direct_control_parameters& p) {
    // NaN, in the first cycle, is no jump
    const double by_count = std::min(std::abs(depth_now - depth) - 2 * dt * std::abs(outward), moved);
    jump = std::max(jump * (1 - std::min(dt / p.jump_time, 1.0)), by_count);
    depth = depth_now;
    return std::max(p.rest_depth, std::min(p.depth_per_jump * jump, p.max_rest_depth));
  }
};

}  // namespace passive_haptics
