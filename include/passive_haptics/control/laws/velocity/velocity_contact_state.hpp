/// Memory of one contact under velocity_direct_control, and the observed motion of the handle.
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
  std::array<double, 3> before{};  ///< In the previous cycle [m].

  /// Returns the distance to x [m] and stores x.
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
/// **Jumps of the depth.** An encoder count moves the handle, and so the depth, by more than its velocity
/// explains. One cycle changes the depth by at most the observed motion of the handle. Any excess comes from
/// the scene (another face, a moved wall, a new sample) and does not increase the steady-state depth.
struct velocity_contact_state {
  double depth = std::numeric_limits<double>::quiet_NaN();  ///< In the previous cycle [m]; NaN if none.
  double jump = 0;  ///< Maximum jump of the depth by a count, with slow decay [m].
  double bias = 0;  ///< b [N]

  /// Steady-state depth [m] after dt [s], a handle motion of `moved` [m] and a velocity `outward` [m/s].
  double rest_depth(double depth_now, double outward, double moved, double dt,
                    const velocity_direct_control_parameters& p) {
    // NaN in the first cycle is no jump
    const double by_count = std::min(std::abs(depth_now - depth) - 2 * dt * std::abs(outward), moved);
    jump = std::max(jump * (1 - std::min(dt / p.jump_time, 1.0)), by_count);
    depth = depth_now;
    return std::max(p.rest_depth, std::min(p.depth_per_jump * jump, p.max_rest_depth));
  }
};

}  // namespace passive_haptics
