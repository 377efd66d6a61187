/// Normal force that velocity_direct_control demands for a wall, and its learning.
#pragma once

#include <passive_haptics/control/laws/velocity/acceleration_display.hpp>
#include <passive_haptics/control/laws/velocity/velocity_contact_state.hpp>
#include <passive_haptics/control/laws/velocity/velocity_direct_control_parameters.hpp>
#include <passive_haptics/core/nth.hpp>
#include <passive_haptics/scene/contacts.hpp>

#include <algorithm>
#include <array>
#include <cstddef>

namespace passive_haptics {

/// Demand of a wall.
template <class T, int D, int Brakes>
struct wall_demand {
  normal_response<T, D, Brakes> along;  ///< Response of the device along the normal.
  T speed_error;                        ///< v_ref - n . v [m/s]: > 0 if the handle should leave faster.
  T stop_speed;                         ///< -n . v [m/s]
  T damping;                            ///< Lambda_n / tau_v [N s/m]
  T feedforward;                        ///< f_ff [N]
  T force;                              ///< f [N]
  velocity_contact_state* state;        ///< Memory of the contact.

  /// True if the handle may not move further in: the wall is touched or demands a force.
  bool is_closed() const { return force > T(0) || state->depth > 0; }

  /// Updates the bias after dt [s] with the force `made` <= `max_force` [N]; sticks: by brakes at rest.
  void learn(T made, T max_force, bool sticks, double dt, const velocity_direct_control_parameters& p) const {
    double& bias = state->bias;
    const double forward = static_cast<double>(feedforward), error = static_cast<double>(speed_error);
    const double rate = static_cast<double>(damping * speed_error) / p.integral_time;
    const bool saturated = made < T(0.999) * force;
    const double let_go = std::min(-dt * error / p.release_length, 1.0) * (forward + bias);
    if (error < 0) bias += sticks ? std::min(dt * rate, -let_go) : dt * rate;
    else if (!saturated && !sticks) bias += dt * rate;
    bias = std::clamp(bias, -std::max(forward, 0.0), std::max(static_cast<double>(max_force) - forward, 0.0));
  }
};

/// Demand of a contact, dt [s] and moved_by [m] after the last cycle. Fh: feedforward [N]. lag: tau_v [s].
template <class M, int D, class Device, class T = typename M::scalar>
wall_demand<T, D, M::brake_count> wall_demand_of(const contact<D>& sensed, const Device& device,
                                                 const pose_dynamics<M>& dynamics, const task_vector<M>& Fh,
                                                 double dt, double moved_by, velocity_contact_state& state,
                                                 const velocity_direct_control_parameters& p, T lag) {
  const contact<D> c = carried_to(device.x, sensed);
  const point<D> n = c.normal.normalized(), relative = as<double>(dynamics.velocity) - c.wall_velocity;
  const double outward = n.dot(relative), curving = relative.dot(c.curvature * relative);
  const double d_ref = state.rest_depth(c.depth, outward, moved_by, dt, p);
  const double v_ref = std::clamp(p.depth_gain * (c.depth - d_ref), -p.velocity_limit, p.velocity_limit);

  const auto along = passive_haptics::response_along(as<T>(n), dynamics, Fh);
  const T speed_error = static_cast<T>(v_ref - outward);
  const T feedforward = -along.inertia * (static_cast<T>(curving) + along.free);
  const T damping = along.inertia / lag;
  const T force = feedforward + static_cast<T>(state.bias) + damping * speed_error;
  return {along, speed_error, static_cast<T>(-outward), damping, feedforward, force, &state};
}

/// Moves walls that demand a force to the front and returns their number. A single wall always counts.
template <class Wall, std::size_t Capacity>
int demanding_first(std::array<Wall, Capacity>& walls, int count) {
  if (count == 1) return 1;
  const auto end =
      std::partition(walls.begin(), walls.begin() + count, [](const Wall& wall) { return wall.force > 0; });
  return static_cast<int>(end - walls.begin());
}

/// w* = w + sum_j g_j p_j [rad/s or m/s], the rates after impulses p that bring the handle to v_ref: n_i .
/// (sum_j J M^-1 J^T n_j p_j) = min(speed_error_i, stop_speed_i), by Gauss-Seidel, exact for one wall.
template <class M, class Wall, std::size_t Capacity>
brake_vector<M> landing_rates(const std::array<Wall, Capacity>& walls, int count,
                              const pose_dynamics<M>& dynamics) {
  using T = typename M::scalar;
  constexpr int sweeps = 4;
  brake_vector<M> w = dynamics.rates;
  task_vector<M> gained = task_vector<M>::Zero();  // velocity
  for (int sweep = 0; sweep < (count > 1 ? sweeps : 1); ++sweep) {
    for (int j = 0; j < count; ++j) {
      const Wall& wall = nth(walls, j);
      const T p =
          wall.along.inertia * (std::min(wall.speed_error, wall.stop_speed) - wall.along.normal.dot(gained));
      gained += wall.along.per_newton * p;
      w += wall.along.g * p;
    }
  }
  return w;
}

}  // namespace passive_haptics
