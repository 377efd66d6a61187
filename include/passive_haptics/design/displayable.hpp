/// @file
/// What brakes can display against a wall at all, while the handle moves in a direction: no law can do more.
#pragma once

#include <passive_haptics/brake/force_generators.hpp>
#include <passive_haptics/brake/models/switchable_brakes.hpp>
#include <passive_haptics/core/finite.hpp>
#include <passive_haptics/core/linear/space_cone.hpp>
#include <passive_haptics/core/status.hpp>
#include <passive_haptics/force/torques/generator_form.hpp>

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
  /// s (m) of the brakes in this motion: -1, 0 or 1.
  brake_vector<M> signs = brake_vector<M>::Zero();
};

namespace detail {

// s of rates w = A v. A rate of the size that rounding of A and E makes it is none: E w = v.
template <class T, int Brakes, int D>
vector<T, Brakes> signs_in_motion(const matrix<T, Brakes, D>& A, const matrix<T, D, Brakes>& E,
                                  const vector<T, D>& v) {
  const vector<T, Brakes> w = A * v;
  const T terms = v.norm() + (E.cwiseAbs() * w.cwiseAbs()).norm();
  const vector<T, Brakes> rounding = rounding_tolerance<T>(D + Brakes) * terms * A.rowwise().norm();
  return (w.array().abs() > rounding.array()).select(w.array().sign(), T(0));
}

// Largest power t . w of torques in the box at rates w. A rate of rounding size is none.
template <class T, int Brakes>
T largest_resistance(const torque_box<T, Brakes>& box, const vector<T, Brakes>& w) {
  const T rounding = rounding_tolerance<T>(Brakes) * w.cwiseAbs().maxCoeff();
  T sum = T(0);
  for (int i = 0; i < Brakes; ++i)
    if (std::abs(w[i]) > rounding) sum += w[i] * (w[i] > T(0) ? box.upper[i] : box.lower[i]);
  return sum;
}

// Least of it over all rates w with E w = n: a sum of w_i, each times a constant of its sign, is least where
// as many as can be are 0, so sets of moving brakes are tried.
template <class T, int D, int Brakes>
T least_resistance(const matrix<T, D, Brakes>& E, const torque_box<T, Brakes>& box, const vector<T, D>& n) {
  const T tolerance = rounding_tolerance<T>(D + Brakes);
  T least = std::numeric_limits<T>::infinity();  // the end effector cannot move so
  for (half_space_set moving = 1; moving < (half_space_set{1} << Brakes); ++moving) {
    matrix<T, D, Brakes> moved = E;
    for (int i = 0; i < Brakes; ++i)
      if ((moving >> i & 1u) == 0) moved.col(i).setZero();
    const vector<T, Brakes> w = orthogonal_decomposition<T, D, Brakes>(moved, tolerance).solve(n);
    const T rounding = tolerance * (T(1) + (moved.cwiseAbs() * w.cwiseAbs()).norm());
    if ((moved * w - n).norm() <= rounding) least = std::min(least, largest_resistance(box, w));
  }
  return least;
}

// Largest k for which the brakes can make torques k t.
template <class B, class T, int Brakes>
T largest_share(const vector<T, Brakes>& t, const B& brakes) {
  const vector<T, Brakes> bound = passive_haptics::torque_bounds_of(brakes, t);
  const auto shares = bound.array() / t.array().abs();
  return (t.array() != T(0)).select(shares, std::numeric_limits<T>::infinity()).minCoeff();
}

template <class M, class Force>
void tell(displayable_force<M>& found, const task_vector<M>& n, const Force& Fc, typename M::scalar strongest,
          const switchable_brakes<M>& brakes) {
  found.display = Fc.display;
  if (!is_displayed(Fc.display)) return;
  const task_vector<M> Fp = Fc.cosine_squared * Fc.force;
  found.angle = std::atan2((n - Fp).norm(), Fp.norm());
  found.strongest = strongest;
  found.strongest_nearest = largest_share(Fc.torque, brakes);
}

// By half-spaces: as many brakes as joints.
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
  tell(found, n, Fc, one_way ? largest_resistance<T, m>(box, A * n) : least_resistance(E, box, n), brakes);
  if (joints > d && found.display == display_class::none && cone_is_zero(E, found.signs, off))
    found.display = display_class::empty_cone;
}

// By generators: redundant brakes, and inertial forces.
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
  const auto Fc = approximate_by_generators(G, unbounded_torque_box_of(found.signs, brakes), n, T(0));
  const brake_vector<M> outwards = G.transpose() * n;
  tell(found, n, Fc, largest_resistance<T, m>(torque_box_of(found.signs, brakes), outwards), brakes);
}

}  // namespace detail

/// What these brakes can display against a wall with normal n while the end effector
/// moves in `direction`, at joint positions q. Direction and normal: base frame, any length > 0; at rest the
/// direction is zero. Of the brakes the limits and intervals are read; limits may be infinite, and a brake
/// whose limit is 0 is off.
///
/// The motion decides the signs: w = T J^+ v, s = sgn(w), and brake i makes s_i t_i <= 0 (3). A brake that
/// rests in this motion (|w_i| of rounding size) can hold either way, so s_i = 0. Of a direction that a
/// singular pose does not allow, the part that it does counts. With self-motion (n > d) the joint rates are
/// taken for the least that make the motion, J^+ v; with inertial forces, for those of a handle that is
/// pulled along, M^-1 J^T Lambda v. More brakes than joints leave nothing to assume.
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
    detail::find_displayable(found, mechanism, q, E, task_vector<M>(direction.stableNormalized()),
                             task_vector<M>(normal.stableNormalized()), brakes);
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
