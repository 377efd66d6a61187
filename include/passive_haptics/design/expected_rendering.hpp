/// @file
/// What a device made of these parts renders at one place: forces, stiffness, depth, times and noise.
#pragma once

#include <passive_haptics/core/linear/orthogonal_decomposition.hpp>
#include <passive_haptics/design/braked_wall_at.hpp>
#include <passive_haptics/design/data_sheet.hpp>
#include <passive_haptics/design/rate_noise.hpp>
#include <passive_haptics/design/rendering.hpp>
#include <passive_haptics/mechanism/adaptors/wrapped_mechanism.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace passive_haptics {
namespace detail {

// M with rotors on its brakes' axes, in a pose at rest: where T depends on q, a motion makes bias torques of
// the rotors, which are not here.
template <class M>
class with_rotors : public wrapped_mechanism<M> {
 public:
  with_rotors(const M& mechanism, const brake_vector<M>& inertia)
      : wrapped_mechanism<M>(mechanism), inertia_(inertia) {}

  // M + T^T diag(inertia) T
  matrix<typename M::scalar, M::dof, M::dof> mass_matrix(const joint_vector<M>& q) const {
    const mechanism_pose<M> pose(this->mechanism(), q);
    const matrix<typename M::scalar, M::dof, M::brake_count> Tt = pose.transposed_transmission();
    return pose.mass_matrix() + Tt * inertia_.asDiagonal() * Tt.transpose();
  }

 private:
  brake_vector<M> inertia_;
};

// The wall of these parts, as the wall calculator takes it.
template <class M>
braked_wall braked_wall_of(const M& mechanism, const data_sheet<M>& parts, const joint_vector<M>& q,
                           const task_vector<M>& velocity, const task_vector<M>& normal) {
  braked_wall wall = braked_wall_at(with_rotors<M>(mechanism, axis_inertia_of(parts)), q, velocity, normal,
                                    axis_brakes_of(parts), axis_residual_of(parts), axis_resolution_of(parts),
                                    static_cast<typename M::scalar>(parts.hand.mass));
  wall.push = parts.hand.push;
  wall.hand_stiffness = parts.hand.stiffness;
  wall.hand_damping = parts.hand.damping;
  wall.control_period = 1 / parts.control_rate;
  wall.scene_period = 1 / parts.scene_rate;
  return wall;
}

// Force of the hand against brakes of these torques while the handle moves so [N]; infinite where it cannot.
template <class M>
double drag_of(const M& mechanism, const joint_vector<M>& q, const task_vector<M>& velocity,
               const brake_vector<M>& torque) {
  return static_cast<double>(
      displayable(mechanism, q, velocity, task_vector<M>(-velocity), torque).strongest);
}

inline banded banded_by(const band& by, double value) {
  const auto [low, high] = std::minmax({by.low * value, by.high * value});  // a force may pull in
  return {value, low, high, by.share, by.source};
}

// Of a depth [m]: give or take a count of the encoders; one that is deep is somewhere below that.
inline banded banded_depth(const wall_limits& limits, double count) {
  constexpr double deep = 0.010;  // [m]
  banded depth = banded_by(rendering_bands::depth, limits.depth);
  depth.low = limits.depth > deep ? std::min(deep, depth.low) : std::max(depth.low - count, 0.0);
  depth.high = limits.depth > deep ? std::numeric_limits<double>::infinity() : depth.high + count;
  return depth;
}

// The forces of a hand that slides along the wall. limits: of this wall.
template <class M>
void find_slide(rendering<M::dof>& r, const M& mechanism, const data_sheet<M>& parts,
                const joint_vector<M>& q, const task_vector<M>& along, const task_vector<M>& n,
                const braked_wall& wall, const wall_limits& limits) {
  const auto found = displayable(mechanism, q, along, n, axis_brakes_of(parts).torque_limit);
  const double push = wall.push - (limits.holds() ? wall.hand_stiffness * limits.depth : 0.0);
  const double demanded = std::max(push - wall.sliding_residual, 0.0);
  const double displayed = std::min(demanded, static_cast<double>(found.strongest_nearest));
  const double against = -displayed * static_cast<double>(along.dot(found.nearest));
  r.holds_push = demanded <= static_cast<double>(found.strongest);
  r.wall_drag =
      banded_by(rendering_bands::wall_drag, drag_of(mechanism, q, along, axis_residual_of(parts)) + against);
  if (!r.holds_push) r.wall_drag.high = std::numeric_limits<double>::infinity();
}

// The noise of the rates while the handle moves with joint rates qd.
template <class M>
void find_noise(rendering<M::dof>& r, const M& mechanism, const data_sheet<M>& parts,
                const jacobian_matrix<M>& J, const joint_vector<M>& qd, const task_vector<M>& n) {
  using axes_vector = encoder_resolution<M>;
  const encoder_axes<M> axes(mechanism);
  const axes_vector rates = axes.from_joints(qd), count = axis_resolution_of(parts);
  double along = 0;
  std::array<double, std::size_t(M::dof)> joints{};
  for (int i = 0; i < encoder_axes<M>::count; ++i) {
    const double sigma = rate_noise(static_cast<double>(rates[i]), static_cast<double>(count[i]),
                                    2 * low_pass_time_constant(parts.rate_corner));
    const joint_vector<M> moved = axes.to_joints(axes_vector::Unit(i));
    along = std::hypot(along, sigma * static_cast<double>(n.dot(J * moved)));
    for (int j = 0; j < M::dof; ++j)
      joints[std::size_t(j)] = std::hypot(joints[std::size_t(j)], sigma * static_cast<double>(moved[j]));
  }
  r.velocity_noise = banded_by(rendering_bands::rate_noise, along);
  for (std::size_t j = 0; j < joints.size(); ++j)
    r.rate_noise[j] = banded_by(rendering_bands::rate_noise, joints[j]);
}

}  // namespace detail

/// What a device of this mechanism, built of these parts, renders at joint positions q, on a wall of normal n
/// (base frame, out of the wall, any length > 0) that the handle touches with `velocity` [m/s]. Depth and
/// release are those under velocity_direct_control, the stiffness that of laws that use one.
///
/// With t_r the residual torques and w the rates of the brakes' axes, u the unit direction of the velocity
/// along the wall, Fc the displayable_force::nearest of this slide, P the hand's push and R_s the
/// sliding_residual:
///
///     free_drag        sum |w_i| t_r,i / |v|                   power of the residual torques at v
///     wall_drag        sum |w_i| t_r,i - N u . Fc              w at u, -u . Fc = tan(gamma) in the plane;
///                                                              N = P - K_h depth - R_s >= 0, but at most
///                                                              strongest_nearest
///     strongest_force  F + R_s                                 F: braked_wall::force
///     stiffness        F_n / rigid_depth                       wall_limits::stiffness
///     depth            of Lambda_n x'' = P - K_h x - B_h x' - R - f,  wall_limits::depth
///     release_time     T_c / 2 + rate_lag + T_f ln 10          T_c: control period, T_f: slowest fall
///     velocity_noise   sqrt(sum (n . J A e_i)^2 sigma_i^2)     sigma_i: rate_noise() of encoder axis i,
///     rate_noise[j]    sqrt(sum (A_ji sigma_i)^2)              A: encoder_axes::to_joints
///
/// A tenth of the torque is left after T_f ln 10. Of a handle at rest, drag and noise are 0. With
/// self-motion, w is the easiest way to move so, and the noise is that of the least joint rates J^+ v.
///
/// Throws std::invalid_argument with the text of validate(parts), as "brakes[1].gear_ratio of a brake [1 or
/// 1/m] = 0, ...", where q, velocity or normal are no such, at a singular pose, and as limits_of does. Bands:
/// docs/guide/data_sheet.md. Cost: that of braked_wall_at and limits_of, and four displayable.
template <Dynamics M>
rendering<M::dof> expected_rendering(const M& mechanism, const data_sheet<M>& parts, const joint_vector<M>& q,
                                     const task_vector<M>& velocity, const task_vector<M>& normal) {
  using T = typename M::scalar;
  require_valid(parts);
  require_no_error(check_value("q", q, "rad or m", range::finite));
  require_no_error(check_value("velocity", velocity, "m/s", range::finite));
  require_no_error(check_value("normal", normal, "", range::direction));
  const jacobian_matrix<M> J(passive_haptics::jacobian(mechanism, q));
  const orthogonal_decomposition<T, M::task_dimension, M::dof> moving(J, rounding_tolerance<T>(M::dof));
  detail::refuse_unless(all_finite(J) && moving.rank() == M::task_dimension, "rank of the Jacobian at q",
                        all_finite(J) ? moving.rank() : 0,
                        detail::indexed("", M::task_dimension, ": choose a pose that is not singular"));

  const braked_wall wall = detail::braked_wall_of(mechanism, parts, q, velocity, normal);
  const wall_limits limits = limits_of(wall);
  const task_vector<M> n = direction_of(normal), along = detail::along_wall(velocity, n);
  double fall = 0;  // [s]
  for (const brake_data& part : parts.brakes) fall = std::max(fall, part.fall_time_constant);

  rendering<M::dof> r;
  r.free_drag = detail::banded_by(rendering_bands::free_drag,
                                  detail::drag_of(mechanism, q, velocity, axis_residual_of(parts)));
  detail::find_slide(r, mechanism, parts, q, along, n, wall, limits);
  r.strongest_force = detail::banded_by(rendering_bands::strongest_force, wall.force + wall.sliding_residual);
  r.stiffness = detail::banded_by(rendering_bands::stiffness, limits.stiffness);
  r.depth = detail::banded_depth(limits, wall.depth_resolution);
  r.release_time =
      detail::banded_by(rendering_bands::release_time,
                        wall.control_period / 2 + wall.reaction_time + fall * std::numbers::ln10);
  detail::find_noise(r, mechanism, parts, J, moving.solve(velocity), n);
  return r;
}

}  // namespace passive_haptics
