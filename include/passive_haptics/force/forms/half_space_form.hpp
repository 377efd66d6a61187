/// Forces of as many brakes as joints (n = m = d): an intersection of half-spaces.
#pragma once

#include <passive_haptics/brake/at_rest/settled_rates.hpp>
#include <passive_haptics/brake/brake_jacobian.hpp>
#include <passive_haptics/brake/force_generators.hpp>
#include <passive_haptics/core/finite.hpp>
#include <passive_haptics/force/approximation.hpp>
#include <passive_haptics/force/desired_force.hpp>
#include <passive_haptics/force/forms/ways_to_move.hpp>
#include <passive_haptics/force/torques/contact_forces.hpp>

#include <cmath>

namespace passive_haptics {
namespace detail {

// True if n . F is a sum over the brakes by G, for n = d; false at singular poses.
template <class M>
bool forces_add_up(const mechanism_pose<M>& pose, const brake_matrix<M>& G) {
  using T = typename M::scalar;
  if (!all_finite(G)) return false;
  if constexpr (M::brake_count != M::dof) return true;
  const T rounding = rounding_tolerance<T>(M::dof);
  const T J = jacobian_matrix<M>(pose.jacobian()).squaredNorm();
  return rounding * J * rounding * G.squaredNorm() < pose.transposed_transmission().squaredNorm();
}

// Sets F to the force G t of its torques. Returns the magnitude of the terms of G t and Fd [N].
template <class Device, class T, int D, int Brakes>
T add_up(approximated_force<T, D, Brakes>& F, const Device& device, const desired_force<T, D>& Fd,
         const matrix<T, D, Brakes>& G) {
  F.force = G * F.torque;
  const matrix<T, D, Brakes> E(device.E);
  const vector<T, Brakes> balance = Fd.magnitude * (absolute(transposed(E)) * absolute(Fd.direction));
  return size_of_terms(G, vector<T, Brakes>(balance + absolute(F.torque)));
}

}  // namespace detail

/// Operations on the forces of M's brakes, by half-spaces. All forms have the same operations.
template <class M>
struct half_space_form {
  using T = typename M::scalar;                ///< Scalar type.
  static constexpr int d = M::task_dimension;  ///< Task dimension.
  static constexpr int m = M::brake_count;     ///< Number of brakes.
  using force = approximated_force<T, d, m>;   ///< Force with its torques.

  /// Fc for a desired force of 1 N: n itself, or the nearest force with Fc . n = 1. Updates `start`.
  template <class Device>
  static force nearest(const Device& device, const desired_force<T, d>& Fd, T min_cosine,
                       approximation_start& start) {
    return approximate(device.E, device.s, Fd.direction, min_cosine, start.half_spaces,
                       passive_haptics::brakes_off(device.s, device.brakes));
  }

  /// Brake signs for the first `count` demands of `wall_count` walls with desired forces wall(j).
  template <int Capacity, class Device, class Demands, class Wall>
  static const brake_vector<M>& signs(const Device& device, const Demands&, int, int, const Wall&,
                                      approximation_start&, force&) {
    return device.s;
  }
  /// Brake signs for effects in addition to walls, for which the brakes produce F with the torques td.
  template <class Device, class Effects>
  static const brake_vector<M>& signs_beside(const Device& device, const force&, const brake_vector<M>&,
                                             const Effects&, approximation_start&) {
    return device.s;
  }
  /// Torques t [N m], 0 for brakes of sign s_i that would drive.
  static brake_vector<M> without_driving(const brake_vector<M>& t, const brake_vector<M>& s) {
    return (s.array() * t.array() > T(0)).select(T(0), t);
  }
  /// Torques [N m] that brakes with signs s produce for the commands td [N m].
  template <class B>
  static const brake_vector<M>& resisting(const brake_vector<M>& td, const brake_vector<M>&, const B&) {
    return td;
  }

  /// Map F = G t.
  template <class EMatrix>
  static force_map<T, d, m> map(const mechanism_pose<M>&, const EMatrix& E) {
    return invert_brake_jacobian(brake_matrix<M>(E));
  }
  /// Units of torques of least norm. Irrelevant here because torques are unique.
  template <class B>
  static equal_units units(const brake_vector<M>&, const B&) {
    return {};
  }
  /// True if brakes with signs s can produce F, to rounding: s_i t_i <= 0 for t = E^T F, 0 if off.
  template <class Device>
  static bool is_in_cone(const Device& device, const brake_vector<M>& s, const brake_matrix<M>& G,
                         const force& F) {
    const brake_matrix<M> E(device.E);
    const brake_vector<M> t = E.transpose() * F.force;
    const T tolerance = rounding_tolerance<T>(1) * size_of_terms(G, F.torque);
    const auto off = passive_haptics::brakes_off(s, device.brakes);
    bool all = true;
    for (int i = 0; i < m; ++i) {
      const T beyond = detail::is_off(off, i) ? std::abs(t[i]) : s[i] * t[i];
      all = all && beyond <= tolerance * E.col(i).norm();
    }
    return all;
  }

  /// Sets F to the force of its torques. Returns the magnitude of its terms [N], for rounding bounds.
  template <class Device>
  static T set_force(force& F, const Device& device, const desired_force<T, d>& Fd,
                     const approximation_start&) {
    return detail::add_up(F, device, Fd, map(device.pose, device.E).G);
  }

  /// Motions of the brakes in pose q, for design.
  template <class B>
  static detail::ways_to_move<T, d, m> motions(const M& mechanism, const joint_vector<M>& q,
                                               const brake_matrix<M>& E, const B&) {
    const mechanism_pose<M> pose(mechanism, q);
    const brake_matrix<M> G = passive_haptics::force_generators(pose);
    if (detail::forces_add_up(pose, G)) return {E, transposed(G), true};
    const jacobian_matrix<M> J(passive_haptics::jacobian(mechanism, q));
    const orthogonal_decomposition<T, d, d> moving(J, rounding_tolerance<T>(d));
    return {E,
            transmission_matrix<M>(transposed(passive_haptics::transposed_transmission(mechanism, q))) *
                moving.pseudo_inverse(),
            false};
  }
  /// Fc for a unit force n while the end effector moves with v. Sets the signs and the brakes held at rest.
  template <class B>
  static force nearest(const detail::ways_to_move<T, d, m>& moving, const brake_matrix<M>& E,
                       const task_vector<M>& v, const task_vector<M>& n, const B& brakes,
                       brake_vector<M>& signs, brake_set&) {
    signs = signs_within(moving.signs(moving.rates(), v), brakes);
    half_space_start start;
    return approximate(E, signs, n, T(0), start, brake_vector<M>(brakes_off(signs, brakes)));
  }
  /// Force F [N] of torques t while the end effector moves and the brakes `held` are at rest.
  static task_vector<M> force_in_motion(const mechanism_pose<M>& pose, const brake_vector<M>& t, brake_set) {
    return passive_haptics::force_generators(pose) * t;
  }
};

}  // namespace passive_haptics
