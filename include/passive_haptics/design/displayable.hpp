/// @file
/// What brakes can display against a wall at all, while the handle moves in a direction: no law can do more.
#pragma once

#include <passive_haptics/brake/force_generators.hpp>
#include <passive_haptics/brake/models/switchable_brakes.hpp>
#include <passive_haptics/core/finite.hpp>
#include <passive_haptics/core/status.hpp>
#include <passive_haptics/design/largest_resistance.hpp>
#include <passive_haptics/force/torques/free_joints.hpp>
#include <passive_haptics/force/torques/generator_form.hpp>
#include <passive_haptics/force/torques/settled_approximation.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace passive_haptics {

/// What can be displayed against a wall of unit normal n (base frame, out of the wall).
template <class M>
struct displayable_force {
  using scalar = typename M::scalar;  ///< Scalar of the mechanism.

  /// ok; else the rest says that there is nothing: state_not_finite (q or the direction), contact_invalid
  /// (no normal), parameters_invalid (a limit), pose_undefined, singular_jacobian (redundant brakes and
  /// inertial forces alone).
  status outcome = status::ok;
  /// none or empty_cone where no producible force has a component along n, at whatever angle: a cycle also
  /// stops at its max_approximation_angle.
  display_class display = display_class::none;
  /// gamma [rad] between n and the nearest producible force: 0 where n itself is one, pi / 2 where none is.
  scalar angle = std::numbers::pi_v<scalar> / scalar(2);
  /// Largest n . F [N] over all forces F that the brakes can make within their limits. Infinite where the
  /// structure itself holds, or a brake without limit.
  scalar strongest = scalar(0);
  /// Largest n . F [N] along the nearest force, by its own torques: what a force approximation, cut to the
  /// limits, displays at most.
  scalar strongest_nearest = scalar(0);
  /// s (m) of the brakes in this motion, once it has settled: -1, 0 or 1.
  brake_vector<M> signs = brake_vector<M>::Zero();
  /// S of the nearest force, a bit for each brake that comes to rest where a self-motion settles; else 0.
  brake_set held = 0;
};

namespace detail {

template <class M, class Force>
void describe(displayable_force<M>& found, const task_vector<M>& n, const Force& Fc,
              typename M::scalar strongest, const switchable_brakes<M>& brakes) {
  found.display = Fc.display;
  if (!is_displayed(Fc.display)) return;
  const task_vector<M> Fp = Fc.cosine_squared * Fc.force;
  found.angle = std::atan2((n - Fp).norm(), Fp.norm());
  found.strongest = strongest;
  found.strongest_nearest = largest_share(Fc.torque, brakes);
}

// By half-spaces, and fewer brakes than joints: a self-motion that is left alone.
template <leaves_free_joints_alone M>
void find_displayable(displayable_force<M>& found, const M& mechanism, const joint_vector<M>& q,
                      const brake_matrix<M>& E, const task_vector<M>& v, const task_vector<M>& n,
                      const switchable_brakes<M>& brakes) {
  using T = typename M::scalar;
  constexpr int m = M::brake_count;
  const mechanism_pose<M> pose(mechanism, q);
  const settled_rates<M> rates(pose, rounding_tolerance<T>(M::dof + m), brakes_without_torque<T, m>(brakes));
  found.signs = signs_within(signs_in_motion<T, m, M::task_dimension>(rates.least_rates(), E, v), brakes);
  const vector<T, m> off = brakes_off(found.signs, brakes);
  const auto Fc = approximate_within(forces_of_braked_joints(pose), E, found.signs, n, T(0), off);
  describe(found, n, Fc, strongest_with_self_motion<M>(rates, torque_box_of(found.signs, brakes), n), brakes);
}

// By half-spaces: as many brakes as joints, and a self-motion that is left alone.
template <class M>
void find_displayable(displayable_force<M>& found, const M& mechanism, const joint_vector<M>& q,
                      const brake_matrix<M>& E, const task_vector<M>& v, const task_vector<M>& n,
                      const switchable_brakes<M>& brakes) {
  using T = typename M::scalar;
  constexpr int d = M::task_dimension, joints = M::dof, m = M::brake_count;
  const jacobian_matrix<M> J(passive_haptics::jacobian(mechanism, q));
  const orthogonal_decomposition<T, d, joints> moving(J, rounding_tolerance<T>(joints));
  const transmission_matrix<M> transmitted =
      transposed(passive_haptics::transposed_transmission(mechanism, q));
  const matrix<T, m, d> A = transmitted * moving.pseudo_inverse();
  found.signs = signs_within(signs_in_motion<T, m, d>(A, E, v), brakes);
  const vector<T, m> off = brakes_off(found.signs, brakes);
  half_space_start start;
  const auto Fc = approximate(E, found.signs, n, T(0), start, off);
  const torque_box<T, m> box = torque_box_of(found.signs, brakes);
  const bool one_way = joints == d && moving.rank() == d;  // of the brakes to move along n
  describe(found, n, Fc, one_way ? largest_resistance<T, m>(box, A * n) : least_resistance(E, box, n),
           brakes);
  if (joints > d && found.display == display_class::none && cone_is_zero(E, found.signs, off))
    found.display = display_class::empty_cone;
}

// Of a self-motion that settles, by the best set of brakes at rest.
template <Settles M>
void find_displayable(displayable_force<M>& found, const M& mechanism, const joint_vector<M>& q,
                      const brake_matrix<M>& E, const task_vector<M>& v, const task_vector<M>& n,
                      const switchable_brakes<M>& brakes) {
  using T = typename M::scalar;
  using rate_map = typename settled_rates<M>::rate_map;
  constexpr int m = M::brake_count;
  constexpr T tolerance = rounding_tolerance<T>(M::dof + m);
  const settled_rates<M> rates(mechanism_pose<M>(mechanism, q), tolerance,
                               brakes_without_torque<T, m>(brakes));
  switchable_brakes<M> in_motion = brakes;
  in_motion.rate_dead_band.setConstant(tolerance * rates.least_rates().norm());
  const settled_forces forces(rates, E, in_motion, v);
  const auto Fc = forces.nearest(n, T(0));
  T strongest = T(0);
  rates.for_each([&](brake_set, const rate_map& W) {
    const torque_box<T, m> box = torque_box_of<switchable_brakes<M>, T, m>(forces.signs_of(W), brakes);
    strongest = std::max(strongest, strongest_with_self_motion<M>(rates, box, n));
    return false;
  });
  found.signs = Fc.signs;
  found.held = Fc.held;
  describe(found, n, Fc, strongest, brakes);
}

// By generators: other than n brakes where n = d, and inertial forces.
template <displays_by_generators M>
void find_displayable(displayable_force<M>& found, const M& mechanism, const joint_vector<M>& q,
                      const brake_matrix<M>& E, const task_vector<M>& v, const task_vector<M>& n,
                      const switchable_brakes<M>& brakes) {
  using T = typename M::scalar;
  constexpr int d = M::task_dimension, m = M::brake_count;
  const auto G = passive_haptics::generators_of(mechanism_pose<M>(mechanism, q));
  if (!all_finite(G)) {
    found.outcome = status::singular_jacobian;
    return;
  }
  found.signs = signs_within(signs_in_motion<T, m, d>(transposed(G), E, v), brakes);
  const auto Fc = approximate_by_generators(G, found.signs, n, T(0), torque_units_of<M>(found.signs, brakes));
  const brake_vector<M> outwards = G.transpose() * n;
  describe(found, n, Fc, largest_resistance<T, m>(torque_box_of(found.signs, brakes), outwards), brakes);
}

}  // namespace detail

/// What these brakes can display against a wall with normal n while the end effector
/// moves in `direction`, at joint positions q. Direction and normal: base frame, any length > 0; at rest the
/// direction is zero. Of the brakes the limits and intervals are read; limits may be infinite, and a brake
/// whose limit is 0 is off.
///
/// The motion decides the signs: w = T J^+ v, s = sgn(w), and brake i makes s_i t_i <= 0 (3). A brake that
/// rests in this motion (|w_i| of rounding size) can hold either way, so s_i = 0. Of a direction that a
/// singular pose does not allow, the part that it does counts. With self-motion (n > d) the rates are those
/// once it has settled, with the brakes at rest that let most be displayed. Where it is left alone
/// (kinetostatic) they are taken for the least that make the motion, J^+ v; with inertial forces, for those
/// of a handle that is pulled along, M^-1 J^T Lambda v. More brakes than joints leave nothing to assume.
///
/// The strongest normal force has any tangential part. By virtual work,
///
///     max n . F = min over joint rates with J qd = n of  sum_i max over |t_i| <= limit_i, s_i t_i <= 0 of
///                 t_i w_i,   w = T qd,
///
/// what brakes make against the easiest way into the wall. For n = d it is the sum over brakes of max(0,
/// n . g_i) limit_i, with g_i = -s_i G e_i (for s_i = 0 of |n . G e_i| limit_i). No law displays more; one
/// that chooses each torque displays that, force approximation gets to strongest_nearest. Where the handle
/// moves along the wall the rest of F is drag, never help: F . v = t . w <= 0. A handle that sinks moves in
/// another direction, in which more can be displayed.
///
/// Never allocates. For looking at a device, not for a control cycle. Cost: a projection (approximate) and
/// one decomposition; at singular poses and with self-motion 2^m decompositions of d x m.
template <class M>
displayable_force<M> displayable(const M& mechanism, const joint_vector<M>& q,
                                 const task_vector<M>& direction, const task_vector<M>& normal,
                                 const switchable_brakes<M>& brakes) {
  static_assert(mechanism_requirements<M>::met && self_motion_requirements<M>::met);
  displayable_force<M> found;
  if (!all_finite(q, direction)) found.outcome = status::state_not_finite;
  else if (!all_finite(normal) || normal.isZero(0)) found.outcome = status::contact_invalid;
  else if (!(brakes.torque_limit.array() >= 0).all() || !(brakes.torque_lower.array() <= 0).all() ||
           !(brakes.torque_upper.array() >= 0).all())
    found.outcome = status::parameters_invalid;
  if (found.outcome != status::ok) return found;
  const brake_matrix<M> E(passive_haptics::brake_jacobian(mechanism, q));
  if (all_finite(E))
    detail::find_displayable(found, mechanism, q, E, direction_of(direction), direction_of(normal), brakes);
  else found.outcome = status::pose_undefined;
  return found;
}

/// What brakes of these torque limits [N m] can display.
template <class M>
displayable_force<M> displayable(const M& mechanism, const joint_vector<M>& q,
                                 const task_vector<M>& direction, const task_vector<M>& normal,
                                 const brake_vector<M>& torque_limit = brake_vector<M>::Constant(
                                     std::numeric_limits<typename M::scalar>::infinity())) {
  switchable_brakes<M> brakes;
  brakes.torque_limit = torque_limit;
  return passive_haptics::displayable(mechanism, q, direction, normal, brakes);
}

}  // namespace passive_haptics
